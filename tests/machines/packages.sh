#!/bin/sh
# Put the libraries that the tests and the program use into a folder, built for
# another machine:
#
#     packages.sh arm64 FOLDER
#
# Debian's packages for that machine are downloaded and unpacked into
# FOLDER/root.  They are not installed: apt gets lists of its own in FOLDER, so
# that neither `dpkg --add-architecture` nor any right is needed, and the system
# stays as it is.  Its sources of packages must have those of the machine, too;
# Debian's do.
set -eu

architecture=$1
packages='check libsubunit-dev libgmp-dev libsuitesparse-dev
libyaml-dev zlib1g-dev'

if ! command -v apt-get >/dev/null || ! command -v dpkg-deb >/dev/null; then
    echo "Debian's apt-get and dpkg-deb are needed to fetch the packages for" \
        "$architecture." >&2
    exit 1
fi

rm -rf "$2"
mkdir -p "$2/lists/partial" "$2/cache/archives/partial" "$2/root"
cd "$2"
: >status
cat >apt.conf <<EOF
APT::Architecture "$architecture";
APT::Architectures { "$architecture"; };
APT::Sandbox::User "";
Acquire::Languages "none";
Dir::State::Lists "$PWD/lists";
Dir::State::Status "$PWD/status";
Dir::Cache "$PWD/cache";
EOF
export APT_CONFIG="$PWD/apt.conf"

apt-get -qq update
apt-get -qq download $packages
for package in *.deb; do
    dpkg-deb -x "$package" root
done
rm -rf lists cache ./*.deb
