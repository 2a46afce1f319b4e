#!/usr/bin/env bash
# The packages for Debian are installed, used and removed:
#   package_test.sh FOLDER        those of a folder, or of a build, in a folder that dpkg takes for a machine: as any user,
#                                 without network
#   package_test.sh --apt FOLDER  those of a folder, on this machine, by apt with all that they need: as root
set -euo pipefail

# used BIN: what somebody does who has no sources, in a folder of his own.
used() {
  [[ $("$1/frond" --version) == "frond "[0-9]* ]]
  "$1/frond" check oak
  "$1/frond" new mine --from vase -q >/dev/null
  "$1/frond" generate mine.json --size 32x18 --out film -q
  grep -q "usr/share/frond/povinc" film/build.ninja
}

unset FROND_HOME FROND_BIN
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
if [[ $1 == --apt ]]; then
  folder=$(realpath -- "$2")
  mapfile -t packages < <(for file in "$folder"/*.deb; do dpkg-deb -f "$file" Package; done)
  export DEBIAN_FRONTEND=noninteractive
  apt-get -q -y install --no-install-recommends "$folder"/*.deb >"$work/apt.log" || { cat "$work/apt.log" && exit 1; }
  dpkg -L "${packages[@]}" | while read -r file; do if [[ ! -d $file ]]; then echo "$file"; fi; done | sort -u >"$work/files"
  mkdir "$work/use"
  cd "$work/use"
  used /usr/bin
  frond render mine.json --size 64x48 --frames 1-1 -o picture
  compgen -G 'picture/**/*.png' >/dev/null || compgen -G 'picture/*.png' >/dev/null
  (cd / && ldconfig -p | grep -q libfrond.so)
  if [[ -d /usr/lib/python3/dist-packages/frond ]]; then python3 -c 'import frond'; fi
  cd "$work"
  apt-get -q -y purge "${packages[@]}" >"$work/apt.log" || { cat "$work/apt.log" && exit 1; }
  while read -r file; do if [[ -e $file ]]; then echo "left: $file"; fi; done <files | tee left
  [[ ! -s left ]]
  echo "installed, used and removed: ${packages[*]}"
  exit
fi

mkdir "$work/debs"
cd -- "$1"
if [[ -f CPackConfig.cmake ]]; then
  cpack -G DEB -B "$work/debs" >"$work/cpack.log" 2>&1 || { cat "$work/cpack.log" && exit 1; }
  rm -r "$work/debs/_CPack_Packages"
else
  cp -- *.deb "$work/debs"
fi
mapfile -t packages < <(for file in "$work"/debs/*.deb; do dpkg-deb -f "$file" Package; done)
root=$work/machine
mkdir -p "$root"/var/lib/dpkg/{updates,info} "$work/bin" "$work/use"
: >"$root/var/lib/dpkg/status"
# What packages call when they are set up is this machine's, which is not concerned.
ln -s /bin/true "$work/bin/ldconfig"
packaging() {
  PATH=$work/bin:$PATH:/usr/sbin:/sbin dpkg --root="$root" --log=/dev/null --force-depends --force-not-root \
    --force-script-chrootless "$@" >"$work/dpkg.log" 2>&1 || { cat "$work/dpkg.log" && exit 1; }
}
things() { find "$root" -path "$root/var/lib/dpkg" -prune -o ! -type d -print; }

packaging -i "$work"/debs/*.deb
cd "$work/use"
used "$root/usr/bin"
for file in bin/frond share/man/man1/frond.1.gz share/bash-completion/completions/frond share/applications/frond-studio.desktop \
  include/frond/frond.h share/doc/frond/changelog.gz; do
  [[ -s $root/usr/$file ]] || { echo "missing: $file" && exit 1; }
done
if [[ " ${packages[*]} " == *" python3-frond "* ]]; then
  PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$root/usr/lib/python3/dist-packages /usr/bin/python3 -c 'import frond; frond.Preset'
fi
# Once more, as when a later one comes, and away.
packaging -i "$work"/debs/*.deb
[[ -x $root/usr/bin/frond ]]
packaging --purge "${packages[@]}"
[[ -z $(things) ]] || { echo "left: $(things)" && exit 1; }
[[ ! -e $root/usr ]] || { echo "left: $(find "$root/usr")" && exit 1; }
echo "installed, used and removed: ${packages[*]}"
