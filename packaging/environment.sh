# shellcheck shell=bash
# What every part takes: version, kernel digest, and an environment in which the same commit gives the same bytes. For scripts to read in
# that have set root.

version=$(sed -n 's/^version = "\(.*\)"/\1/p' "$root/Cargo.toml" | head -1)
digest=$(sed -n 's/.*KERNEL_DIGEST: u64 = 0x\([0-9a-f_]*\);/\1/p' "$root/kernel/src/identity.rs" | head -1 | tr -d _)

# Dates in archives are that of the commit; of sources without one, that of their youngest file.
export SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git -C "$root" log -1 --format=%ct 2>/dev/null ||
    find "$root" -path "$root/target" -prune -o -type f -printf '%Ts\n' | sort -n | tail -1)}
export LC_ALL=C TZ=UTC
umask 022

# No folder of this machine in a binary.
remap="--remap-path-prefix=$root=/softanvil --remap-path-prefix=${CARGO_HOME:-$HOME/.cargo}=/cargo"
remap+=" --remap-path-prefix=$(rustc --print sysroot)=/rust"
export RUSTFLAGS=$remap

# archive FILE FOLDER NAME...: a tar file of what stands in the folder, with nothing of this machine or of today in it.
archive() {
    local file=$1 folder=$2; shift 2
    tar -C "$folder" --sort=name --format=gnu --owner=0 --group=0 --numeric-owner --mtime="@$SOURCE_DATE_EPOCH" \
        --mode=u+rw,go+r,go-w -cf - "$@" | gzip -9n >"$file"
}

# python_with NAME PACKAGE...: a virtual environment of that name with these packages, in target; its folder is printed.
python_with() {
    local venv=$root/target/$1; shift
    [ -x "$venv/bin/python" ] || python3 -m venv "$venv" >&2 || return 1
    "$venv/bin/python" -m pip install --quiet --disable-pip-version-check "$@" >&2 || return 1
    echo "$venv"
}
