# shellcheck shell=bash
# For scripts to read in.

# need COMMAND PACKAGE...: installs Debian packages if COMMAND is missing and we may.
need() {
    local command=$1; shift
    command -v "$command" >/dev/null && return 0
    [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null || return 1
    { apt-get -qq update && DEBIAN_FRONTEND=noninteractive apt-get -qq install -y --no-install-recommends "$@"; } \
        >/dev/null && command -v "$command" >/dev/null
}
