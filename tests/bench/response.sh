# Time responses and print what figures/response.csv holds:
#
#     response.sh COMPILER FLAGS RESPONSE
#
# A head of lines "# what: text" says where the numbers are from.  Then comes a
# line a number, "name,value,unit", of the table that the program RESPONSE
# prints.  `make measure-response` runs this.
set -eu

machine=$(sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo | head -n 1)

cat <<END
# Written by \`make measure-response\`; the book reads it.
# machine: ${machine:-$(uname -m)}
# compiler: $($1 --version | head -n 1), $2
# date: $(date +%Y-%m-%d)
# command: make measure-response
name,value,unit
END
"$3" | awk '
    # "14/186/  0" is one field; a name may be more than one.
    { gsub(/\/ */, "/") }
    NR == 1 { next }
    {
        name = $1
        for (i = 2; i <= NF - 13; i++)
            name = name " " $i
        split($(NF - 11), steps, "/")
        print name " vertices," $(NF - 12) ","
        print name " steps clear," steps[1] ","
        print name " steps by zones," steps[2] ","
        print name " steps by failsafe," steps[3] ","
        print name " rounds," $(NF - 10) ","
        print name " most rounds," $(NF - 9) ","
        print name " contacts," $(NF - 8) ","
        print name " detection," $(NF - 7) ",s"
        print name " response," $(NF - 6) ",s"
        print name " ratio," $(NF - 5) ","
        print name " worst ratio," $(NF - 4) ","
        print name " clear ratio," $(NF - 3) ","
        print name " held," $(NF - 2) ","
        print name " pairs," $NF ","
    }'
