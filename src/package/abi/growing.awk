# List the structs of tanglefree.h that may get more members, as XML:
#
#     <!-- Tanglefree 1.0.0; may grow: tf_one tf_two -->
#
# They are those that begin with their size, and those of which the comment says
# that later versions may add to their end.

/^\/\/\// {
    comment = comment " " substr($0, 4)
}

/^ *size_t size;/ && begins {
    grows[++count] = name
}

!/^ *\/\/\// {
    begins = 0
}

/^typedef struct [a-z0-9_]+ [{]/ {
    name = $3
    begins = 1
    gsub(/ +/, " ", comment)
    if (comment ~ /[Ll]ater versions may add (members )?to its end[.]/)
        grows[++count] = name
}

!/^\/\/\// {
    comment = ""
}

/^#define TF_VERSION "/ {
    version = substr($3, 2, length($3) - 2)
}

END {
    printf "<!-- Tanglefree %s; may grow:", version
    for (i = 1; i <= count; i++)
        printf " %s", grows[i]
    print " -->"
}
