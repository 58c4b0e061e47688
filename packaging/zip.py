"""zip.py FILE FOLDER NAME: a zip file of what stands in FOLDER/NAME, the same bytes for the same files. Its date is SOURCE_DATE_EPOCH."""

import os
import sys
import time
import zipfile
from pathlib import Path

file, folder, name = sys.argv[1:]
date = time.gmtime(int(os.environ["SOURCE_DATE_EPOCH"]))[:6]
with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
    for path in sorted(Path(folder, name).rglob("*")):
        if path.is_file():
            entry = zipfile.ZipInfo(path.relative_to(folder).as_posix(), date)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = (0o755 if os.access(path, os.X_OK) else 0o644) << 16
            archive.writestr(entry, path.read_bytes(), compresslevel=9)
