# shellcheck shell=bash
# The library as a package of Conan 2, built from its recipe in a home of its own and tested by a program, static and shared.
mkdir -p "$out/conan"
if venv=$(python_with packaging-conan 'conan>=2.4,<3'); then
    export CONAN_HOME=$work/conan
    rm -rf "$CONAN_HOME"
    "$venv/bin/conan" profile detect >/dev/null 2>&1
    for shared in False True; do
        "$venv/bin/conan" create packaging/conan -verror -o "softanvil/*:shared=$shared"
    done
    "$venv/bin/conan" cache save "softanvil/$version:*" -verror --file "$out/conan/softanvil-$version-conan.tgz" >/dev/null
    python3 packaging/conan/repack.py "$out/conan/softanvil-$version-conan.tgz"
else
    skip conan "Conan cannot be installed"
fi
