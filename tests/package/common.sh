# What the checks of the installation share.  `make check-install` runs them in
# the folder of the Makefile, with BUILD, VERSION and MAKE.
set -eu

scratch=$BUILD/install
prefix=$scratch/prefix
header=$prefix/include/tanglefree.h

fail() {
    echo "check-install: $*" >&2
    exit 1
}

installed() {
    PKG_CONFIG_PATH=$prefix/lib/pkgconfig pkg-config "$@"
}

readme() { # kind of the block
    sed -n "/^\`\`\`$1\$/,/^\`\`\`\$/{/^\`\`\`/d;p}" README.md
}
