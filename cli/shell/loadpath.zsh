#compdef loadpath
# Completion for zsh: the program itself says what fits, so that nothing here can go stale.
_loadpath() {
  local line files=
  local -a found
  for line in "${(@f)$(loadpath completion candidates -- "${(@)words[2,CURRENT]}" 2>/dev/null)}"; do
    case $line in
      '') ;;
      :files) files=yes ;;
      *) found+=("${${line%%$'\t'*}//:/\\:}:${line#*$'\t'}") ;;
    esac
  done
  (( ${#found} )) && _describe 'loadpath' found
  [[ -n $files ]] && _files
}
# From the folder of completions this file is the function itself; sourced, it names it.
if [[ $funcstack[1] == _loadpath ]]; then
  _loadpath "$@"
else
  compdef _loadpath loadpath
fi
