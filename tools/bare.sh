# Makes a fresh, minimal Debian 12 at $bare for the scripts that source this file; removes it at their end unless $keep is set.
# Needs root. Packages come from wherever this machine gets its own: apt's configuration and the name service are copied in.
[ "$(id -u)" -eq 0 ] || { echo "bare: needs root (for debootstrap and chroot)" >&2; exit 1; }
sh tools/install-deps bare

bare=$(mktemp -d "${TMPDIR:-/tmp}/yoke-bare.XXXXXX")
chmod 755 "$bare"
leave() {
    for mounted in proc dev; do
        ! mountpoint -q "$bare/$mounted" || umount "$bare/$mounted" || umount -l "$bare/$mounted"
    done
    if [ -n "$keep" ]; then
        echo "kept: $bare"
    else
        rm -rf --one-file-system "$bare"
    fi
}
trap leave EXIT
trap 'exit 1' INT TERM HUP

# The mirror that this machine's apt uses for the release itself (not for its updates).
mirror=$(apt-get indextargets --format '$(CODENAME) $(SITE)' 'Created-By: Packages' | sed -n 's/^bookworm //p' | grep -v security | head -n 1)
[ -n "$mirror" ] || { echo "bare: apt knows no mirror of bookworm here; try apt-get update" >&2; exit 1; }
proxy=
eval "$(apt-config shell proxy Acquire::http::Proxy)"
echo "== bare: debootstrap"
http_proxy="${http_proxy:-$proxy}" debootstrap --variant=minbase bookworm "$bare" "$mirror" >"$bare.log" 2>&1 ||
    { tail -n 30 "$bare.log"; exit 1; }
rm -f "$bare.log"
for what in sources.list sources.list.d apt.conf apt.conf.d preferences.d keyrings trusted.gpg trusted.gpg.d; do
    rm -rf "$bare/etc/apt/$what"
    [ -e "/etc/apt/$what" ] || continue
    cp -rL "/etc/apt/$what" "$bare/etc/apt/$what"
done
cp -L /etc/resolv.conf /etc/hosts "$bare/etc/"
mount -t proc proc "$bare/proc" || mount --bind /proc "$bare/proc"
mount --bind /dev "$bare/dev"
