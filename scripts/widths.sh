#!/bin/sh
# Runs all examples and published cases, `loadpath verify` and sweeps on this CPU, with the C library's plain functions in
# place of those for FMA, and on CPUs of qemu-user with SSE2 and with AVX2. Reports, terminal output and exit codes must be
# equal; numbers of full precision (JSON, CSV) too wherever the C library's functions return the same. Three minutes on two
# cores.
# Usage: sh scripts/widths.sh [PROGRAM [REFERENCE]]; with REFERENCE, the program of another compiler, the two are compared
# here, displayed digits only.
set -eu
cd "$(dirname "$0")/.."
. scripts/packages.sh
install_missing $width_packages

[ "$(uname -m)" = x86_64 ] || { echo "error: vector widths are those of x86-64" >&2; exit 1; }
program=$(realpath "${1:-build/release/cli/loadpath}")
reference=${2:+$(realpath "$2")}
sources=$(pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Dispatched like the loops of the program; and a hash of what the C library's functions return.
cat >"$work/probe.cpp" <<'PROBE'
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>

__attribute__((target("default"))) const char* width() { return "SSE2"; }
__attribute__((target("arch=x86-64-v3"))) const char* width() { return "AVX2"; }
__attribute__((target("arch=x86-64-v4"))) const char* width() { return "AVX-512"; }

int main() {
  std::uint64_t hash = 0;
  const auto take = [&](double x) {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    hash = (hash ^ bits) * 0x9e3779b97f4a7c15U;
    hash ^= hash >> 29;
  };
  for (int i = 1; i <= 20000; ++i) {
    const double x = 3e-4 * i, y = 1.0 / (1.0 + x);
    take(std::sin(x)), take(std::cos(x)), take(std::tan(x)), take(std::exp(x)), take(std::log(x)), take(std::pow(x, 0.3));
    take(std::atan(x)), take(std::atan2(y, x)), take(std::asin(y)), take(std::acos(y)), take(std::cbrt(x)), take(std::erfc(y));
    take(std::expm1(y)), take(std::log1p(y)), take(std::hypot(x, y)), take(std::tgamma(y)), take(std::log10(x));
  }
  std::printf("%s %016llx\n", width(), static_cast<unsigned long long>(hash));
}
PROBE
g++ -std=c++20 -O2 -ffp-contract=off "$work/probe.cpp" -o "$work/probe"

# on VARIANT COMMAND...: runs it natively or as the variant says.
on() {
  variant=$1; shift
  case $variant in
    native | reference) "$@" ;;
    libc) GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX,-AVX2,-AVX512F,-FMA,-FMA4 "$@" ;;
    sse2) qemu-x86_64 -cpu Nehalem "$@" ;;
    avx2) qemu-x86_64 -cpu Haswell-noTSX,pcid=off,x2apic=off,tsc-deadline=off,invpcid=off "$@" ;;  # off: unknown to qemu
  esac
}

# keep NAME VARIANT COMMAND...: its output, errors and exit code.
keep() {
  name=$1 code=0; shift
  on "$@" >"$name.out" 2>"$name.err" || code=$?
  echo $code >"$name.code"
}

# run_project VARIANT PROGRAM FILE: report and terminal, then full precision.
run_project() {
  name=$(echo "${3#"$sources"/}" | tr / -)
  keep "$name" "$1" "$2" run "$3" --detail full --report "$name.md"
  on "$1" "$2" run "$3" --json >"$name.json" 2>/dev/null || :
}

# sweep_example VARIANT PROGRAM NAME EXAMPLE OPTIONS...
sweep_example() {
  variant=$1 program=$2 name=sweep-$3 file=$sources/examples/$4/project.toml; shift 4
  keep "$name" "$variant" "$program" sweep "$file" "$@" --report "$name.md"
  on "$variant" "$program" sweep "$file" "$@" --json >"$name.json" 2>/dev/null || :
}

# solve VARIANT PROGRAM: everything that is compared, into a folder; the names in it do not contain the variant.
solve() (
  mkdir "$work/$1" && cd "$work/$1"
  for file in "$sources"/examples/*/project.toml "$sources"/reference/*.toml "$sources"/reference/init/*.toml; do
    run_project "$1" "$2" "$file"
  done
  keep verify "$1" "$2" verify --full
  sweep_example "$1" "$2" points strut-sweep --csv points.csv --pareto "mass:min,u:min"
  sweep_example "$1" "$2" best strut-sweep --minimise mass --such-that "strut passes" --quantile 0.99 --samples 100
  sweep_example "$1" "$2" influence strut-sweep --influence --sobol 256
  sweep_example "$1" "$2" torsion line-shaft --samples 2000 --latin --csv torsion.csv \
    --set 'line_shaft.tau_adm={ scale = "40 MPa", shape = 12 }' --set 'line_shaft.G={ mean = "80 GPa", sd = "2 %" }' \
    --results line_shaft.d_min --results line_shaft.u_tau
  sweep_example "$1" "$2" gears gear-stage --samples 10 --csv gears.csv \
    --set 'gears.beta={ from = "8 deg", to = "20 deg", count = 13 }' --set 'gears.x_1={ min = 0.1, max = 0.5 }' \
    --results gears.utilisation --results gears.m_n
  sweep_example "$1" "$2" lanes toggle-press --samples 16 --csv lanes.csv --set 'press.r={ mean = "40 mm", sd = "1 %" }' \
    --results "peak(press.drive.M)" --results shaft.utilisation
  sweep_example "$1" "$2" history load-history --samples 32 --csv history.csv \
    --set 'neck.sigma_D={ mean = "200 MPa", sd = "5 %" }' --results neck.D
)

# printed VARIANT: reports, terminal, exit codes and the words of figures, into VARIANT.printed; coordinates of figures are
# no digits that people read.
printed() (
  mkdir "$work/$1.printed" && cd "$work/$1"
  cp ./*.md ./*.out ./*.err ./*.code "../$1.printed"
  for figure in ./*.svg; do sed 's/="[^"]*"/=""/g' "$figure" >"../$1.printed/$figure"; done
)

bad=""

# same_print A B: the first lines that differ are shown.
same_print() {
  diff -r "$work/$1.printed" "$work/$2.printed" >"$work/differences" && return
  echo "error: $2 prints something else than $1:" >&2
  sed "s#$work/##g" "$work/differences" | head -n 40 | cut -c 1-200 >&2
  bad=yes
}

# count_bits A B: of `all` files of full precision `unlike` differ.
count_bits() {
  unlike=0 all=0
  for file in "$work/$1"/*.json "$work/$1"/*.csv; do
    all=$((all + 1))
    cmp -s "$file" "$work/$2/${file##*/}" || unlike=$((unlike + 1))
  done
}

# both A PROGRAM B PROGRAM: at the same time.
both() {
  solve "$1" "$2" &
  solve "$3" "$4"
  wait $!
}

if [ -n "$reference" ]; then
  both native "$program" reference "$reference"
  printed native && printed reference
  same_print reference native
  count_bits reference native
  files=$(ls "$work/native.printed" | wc -l)
  echo "$files printed files of $program compared with those of $reference; of $all files of full precision $unlike differ"
  [ -z "$bad" ]; exit
fi

for variant in native libc sse2 avx2; do on $variant "$work/probe" >"$work/$variant.probe"; done
width_of() { cut -d ' ' -f 1 "$work/$1.probe"; }
library_of() { cut -d ' ' -f 2 "$work/$1.probe"; }
[ "$(width_of sse2) $(width_of avx2)" = "SSE2 AVX2" ] || { echo "error: qemu's CPUs have not the widths asked for" >&2; exit 1; }

both native "$program" libc "$program"
both sse2 "$program" avx2 "$program"
printed native
for variant in libc sse2 avx2; do
  printed $variant
  same_print native $variant
done
for pair in "native libc" "native sse2" "native avx2" "libc sse2"; do
  set -- $pair
  count_bits $1 $2
  if [ "$(library_of $1)" = "$(library_of $2)" ]; then
    library="C library's functions alike"
    [ "$unlike" = 0 ] || { echo "error: $1 and $2 have unlike bits" >&2; bad=yes; }
  else
    library="C library's functions unlike"
  fi
  echo "$1 ($(width_of $1)) and $2 ($(width_of $2)), $library: of $all files of full precision $unlike differ"
done
case $(width_of native) in AVX-512) lacking="" ;; AVX2) lacking="AVX-512" ;; *) lacking="AVX-512 (and AVX2 but in qemu)" ;; esac
echo "widths compared: $(width_of native) here, SSE2 and AVX2 in qemu; not compared, for this CPU lacks it: ${lacking:-none}"
[ -z "$bad" ]
