# Time responses, see measure.sh:
#
#     response.sh RESPONSE
#
# The numbers are those of the table that the program RESPONSE prints.
set -eu

"$1" | awk '
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
