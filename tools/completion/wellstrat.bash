# SPDX-License-Identifier: Apache-2.0
#
# Completion of `wellstrat` in bash: sub-commands and options as --help lists them, and files.

_wellstrat() {
    local program=${COMP_WORDS[0]} word=${COMP_WORDS[COMP_CWORD]} help names=
    if [ "$COMP_CWORD" -eq 1 ]; then
        help=$("$program" --help 2> /dev/null)
        names=$(sed -n '/^Subcommands:/,/^$/s/^  \([a-z]\+\) .*/\1/p' <<< "$help")
    else
        help=$("$program" "${COMP_WORDS[1]}" --help 2> /dev/null)
    fi
    if [[ $word == -* ]]; then
        names=$(sed -n '/^Options:/,/^$/s/^  \(-[^ ]*\).*/\1/p' <<< "$help" | tr ',' '\n')
    fi
    mapfile -t COMPREPLY < <(compgen -W "$names" -- "$word")
}

# Where there is nothing to choose from, bash completes names of files.
complete -o default -F _wellstrat wellstrat wellstrat-render
