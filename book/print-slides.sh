# Print all decks of $BUILD/slides as PDF.
set -eu

folder=$(cd "$BUILD/slides" && pwd)
scratch=$(mktemp -d "$folder/print.XXXX")
trap 'rm -rf "$scratch"' EXIT
for deck in "$folder"/[1-9]*.html; do
    pdf=${deck%.html}.pdf
    rm -f "$pdf"
    chromium --headless --no-sandbox --disable-dev-shm-usage \
        --user-data-dir="$scratch" --no-pdf-header-footer \
        --print-to-pdf="$pdf" "file://$deck" >"$scratch/log" 2>&1 || true
    [ -s "$pdf" ] || { cat "$scratch/log" >&2; exit 1; }
done
