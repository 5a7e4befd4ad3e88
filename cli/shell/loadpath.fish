# Completion for fish: the program itself says what fits, so that nothing here can go stale.
function __loadpath
    set -l words (commandline -opc) (commandline -ct)
    for line in (loadpath completion candidates -- $words[2..-1] 2>/dev/null)
        if test "$line" = ':files'
            __fish_complete_path (commandline -ct)
        else
            echo $line
        end
    end
end
complete -c loadpath -f -a '(__loadpath)'
