#!/bin/sh
# The sum that ccache takes for that of a compiled header: headers_sum.sh OPTIONS HEADER.pch writes HEADER.pch.sum. It is of
# all texts that HEADER.pch.d names. Where one cannot be read there is no sum, and ccache looks at the header itself.
rm -f "$2.sum"
if tr -d '\\' <"$2.d" | tr ' ' '\n' | grep '^/.*[^:]$' | xargs cat >"$2.texts"; then
  { echo "$1"; cat "$2.texts"; } | sha256sum >"$2.sum"
fi
rm -f "$2.texts"
