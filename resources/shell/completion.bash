# Completes the arguments of halfspace in bash. The program itself knows its commands, options and lessons.

_halfspace() {
  local files
  COMPREPLY=()
  {
    read -r files
    mapfile -t COMPREPLY
  } < <("$1" complete-words "${COMP_WORDS[@]:1:COMP_CWORD}" 2>/dev/null)
  [[ -n $files ]] || return 0
  compopt -o filenames
  mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -A "$files" -- "$2")
}
complete -F _halfspace halfspace
