"""repack.py FILE: what `conan cache save` has written, with the same bytes for the same content. Conan names the folders of packages
at random and puts the time into archive, list and manifests; here they have the names of the packages, and the time is
SOURCE_DATE_EPOCH."""

import gzip
import io
import json
import os
import sys
import tarfile

LIST, MANIFEST = "pkglist.json", "conanmanifest.txt"


def rename(packages, epoch):
    """Sets the times in the list of packages, and tells which names the folders of packages get. That of a recipe comes from its name."""
    folders = {}
    for recipe in packages.values():
        for made in recipe["revisions"].values():
            made["timestamp"] = float(epoch)
            for package, built in made["packages"].items():
                for found in built["revisions"].values():
                    found["timestamp"] = float(epoch)
                    folder = os.path.dirname(found["package_folder"])
                    folders[folder] = f"b/package{package[:10]}"
                    for key in ("package_folder", "metadata_folder"):
                        found[key] = found[key].replace(folder, folders[folder])
    return folders


def repack(file, epoch):
    with tarfile.open(file) as archive:
        members = [(member, archive.extractfile(member).read() if member.isfile() else b"") for member in archive]
    packages = json.loads(next(content for member, content in members if member.name == LIST))
    folders = rename(packages, epoch)
    packed = []
    for member, content in members:
        folder = next((folder for folder in folders if member.name.startswith(folder + "/")), None)
        if folder:
            member.name = folders[folder] + member.name.removeprefix(folder)
        if member.name == LIST:
            content = json.dumps(packages, indent=2, sort_keys=True).encode()
        if os.path.basename(member.name) == MANIFEST:
            content = b"\n".join([str(epoch).encode(), *content.split(b"\n")[1:]])
        member.mtime, member.size, member.pax_headers = epoch, len(content), {}
        packed.append((member, content))
    with open(file, "wb") as out, gzip.GzipFile("", "wb", mtime=epoch, fileobj=out) as zipped:
        with tarfile.open(fileobj=zipped, mode="w") as archive:
            for member, content in sorted(packed, key=lambda item: item[0].name):
                archive.addfile(member, io.BytesIO(content))


repack(sys.argv[1], int(os.environ["SOURCE_DATE_EPOCH"]))
