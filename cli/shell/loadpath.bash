# Completion for bash: the program itself says what fits, so that nothing here can go stale.
_loadpath() {
  local line found=() files=
  while IFS= read -r line; do
    case $line in
      :files) files=yes ;;
      *) found+=("${line%%$'\t'*}") ;;
    esac
  done < <(loadpath completion candidates -- "${COMP_WORDS[@]:1:COMP_CWORD}" 2>/dev/null)
  COMPREPLY=("${found[@]}")
  [ -z "$files" ] || mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -f -- "${COMP_WORDS[COMP_CWORD]}")
  [ -z "$files" ] || compopt -o filenames 2>/dev/null
}
complete -F _loadpath loadpath
