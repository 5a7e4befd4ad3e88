#!/bin/sh
# sh cmake/ccache.sh CCACHE COMPILER ARGUMENTS...: compiles by ccache, but for precompiled headers: g++ recognises a header with
# #pragma once in them by its time too, which another checkout of the same content changes.
ccache=$1
shift
before=
for word; do
  case $before:$word in -o:*.gch | -o:*.pch) exec "$@" ;; esac
  before=$word
done
exec "$ccache" "$@"
