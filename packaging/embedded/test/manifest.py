"""manifest.py LIBRARY_JSON: PlatformIO accepts the manifest. Names of licences it compares with a list from the network, without which
all else is checked."""

import sys

from platformio.package.exception import ManifestValidationError
from platformio.package.manifest.parser import ManifestParserFactory
from platformio.package.manifest.schema import ManifestSchema

try:
    ManifestSchema().load_manifest(ManifestParserFactory.new_from_file(sys.argv[1]).as_dict())
except ManifestValidationError as error:
    assert error.messages == {"license": ["Could not load SPDX licenses for validation"]}, error
    print("PlatformIO accepts the manifest; names of licences were not checked, without a network")
else:
    print("PlatformIO accepts the manifest")
