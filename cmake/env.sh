# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Sourced by any POSIX shell, ". PREFIX/env.sh": programs, packages and components of this prefix are found first, and
# OROCOS_TARGET is set. It may be moved, and sourced twice. Where a shell does not tell which file it reads, set OROFORGE_PREFIX before.

# The folder of this file. What one shell calls a syntax error is kept from the others by eval.
_oroforge_place=
if [ -n "${BASH_VERSION:-}" ]; then
    eval '_oroforge_place=${BASH_SOURCE[0]}'
elif [ -n "${ZSH_VERSION:-}" ]; then
    eval '_oroforge_place=${(%):-%x}'
elif case ${KSH_VERSION:-} in *93*) ;; *) false ;; esac; then
    eval '_oroforge_place=${.sh.file}'
else
    # The shell, the parent of a substitution's process, reads this file through one of its open files.
    _oroforge_place=$(
        read -r _oroforge_own _oroforge_name _oroforge_state _oroforge_shell _oroforge_rest < /proc/self/stat
        for _oroforge_open in /proc/"$_oroforge_shell"/fd/* /proc/"$_oroforge_own"/fd/* /proc/$$/fd/*; do
            _oroforge_file=$(readlink "$_oroforge_open" 2> /dev/null)
            case $_oroforge_file in
                */env.sh)
                    if [ -d "${_oroforge_file%/env.sh}/lib/cmake/orocos-rtt" ]; then
                        printf '%s\n' "$_oroforge_file"
                        break
                    fi ;;
            esac
        done
    )
fi
if [ -n "$_oroforge_place" ]; then
    _oroforge_prefix=$(CDPATH='' cd -- "$(dirname -- "$_oroforge_place")" && pwd)
else
    _oroforge_prefix=${OROFORGE_PREFIX:-}
fi

# Run by a shell of its own it changes nothing for its user. (In zsh, $0 is the file that is being read.)
if [ -z "${ZSH_VERSION:-}" ] && [ -n "$_oroforge_place" ] && [ "$0" -ef "$_oroforge_place" ]; then
    echo "env.sh: this changes nothing, because it was run; have the shell read it: . $0" >&2
fi

# _oroforge_put NAME FOLDER: at the front of the list, unless it is in there.
_oroforge_put() {
    eval "_oroforge_list=\${$1:-}"
    case ":$_oroforge_list:" in
        *":$2:"*) ;;
        *) eval "$1=\$2\${_oroforge_list:+:\$_oroforge_list}" ;;
    esac
    eval "export $1"
}

if [ -d "$_oroforge_prefix/lib/cmake/orocos-rtt" ]; then
    _oroforge_put PATH "$_oroforge_prefix/bin"
    _oroforge_put CMAKE_PREFIX_PATH "$_oroforge_prefix"
    _oroforge_put PKG_CONFIG_PATH "$_oroforge_prefix/lib/pkgconfig"
    _oroforge_put RTT_COMPONENT_PATH "$_oroforge_prefix/lib/orocos"
    if [ -d "$_oroforge_prefix/share/rtt_ros" ]; then
        _oroforge_put ROS_PACKAGE_PATH "$_oroforge_prefix/share"
        _oroforge_put PYTHONPATH "$_oroforge_prefix/lib/python3/dist-packages"
    fi
    # The programs want to know which target; where there is but one, it is meant.
    if [ -z "${OROCOS_TARGET:-}" ]; then
        for _oroforge_target in "$_oroforge_prefix"/bin/rttscript-*; do
            if [ -x "$_oroforge_target" ]; then OROCOS_TARGET=${_oroforge_target##*/rttscript-}; fi
        done
        export OROCOS_TARGET
    fi
    for _oroforge_lua in "$_oroforge_prefix/share/lua/5.1" "$_oroforge_prefix/share/oroforge/lua"; do
        if [ -d "$_oroforge_lua" ]; then
            # Lua's patterns are separated by semicolons; two of them at the end stand for what it has by itself.
            case ";${LUA_PATH:-;};" in
                *";$_oroforge_lua/?.lua;"*) ;;
                *) LUA_PATH="$_oroforge_lua/?.lua;${LUA_PATH:-;}" ;;
            esac
            export LUA_PATH
        fi
    done
    unset _oroforge_place _oroforge_prefix _oroforge_lua _oroforge_list _oroforge_target
    unset -f _oroforge_put
else
    echo "env.sh: there is no toolchain in '$_oroforge_prefix', where this file is thought to be; set OROFORGE_PREFIX to its prefix" >&2
    unset _oroforge_place _oroforge_prefix _oroforge_lua _oroforge_list
    unset -f _oroforge_put
    return 1
fi
