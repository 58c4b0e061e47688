# shellcheck shell=bash
# Wheels and sdist (python/wheels.sh); that of this machine is installed and asked which kernel it is.
mkdir -p "$out/wheels"
if need x86_64-w64-mingw32-gcc gcc-mingw-w64-x86-64; then
    python/wheels.sh "$out/wheels"
    # What the builder itself writes into a wheel is not remapped.
    python3 - "$root" "$out"/wheels/*.whl <<'EOF'
import sys, zipfile
for wheel in sys.argv[2:]:
    archive = zipfile.ZipFile(wheel)
    for name in archive.namelist():
        if sys.argv[1].encode() in archive.read(name):
            sys.exit(f"{wheel}: {name} names the folder {sys.argv[1]}")
EOF
    venv=$(python_with packaging-wheels --force-reinstall --find-links "$out/wheels" "softanvil==$version")
    (cd "$work" && "$venv/bin/python" -c 'import softanvil; print("kernel digest", softanvil.kernel_digest)') | grep " $digest\$"
else
    skip wheels "x86_64-w64-mingw32-gcc is missing and cannot be installed"
fi
