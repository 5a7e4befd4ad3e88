# How .ci/run counts its jobs and ends. Sourced by bash.
passed=0
failed=0
table=""  # of the jobs that have run: seconds, name, outcome
logs=build/ci
rm -rf "$logs"
mkdir -p "$logs"

# Whether a job is to run: all of them, or the one that --only names.
is_wanted() { [ -z "$only" ] || [ "$only" = "$1" ]; }

# job NAME COMMAND...: runs a command, counts it and keeps what it prints. Its status is the command's.
job() {
  local name=$1 started=$SECONDS status outcome=passed
  shift
  is_wanted "$name" || return 0
  log="$logs/$name.log"
  printf '\n== %s\n' "$name"
  (set -o pipefail; "$@" 2>&1 | tee "$log")
  status=$?
  if [ $status = 0 ]; then passed=$((passed + 1)); else failed=$((failed + 1)) outcome=FAILED; fi
  table+="$((SECONDS - started))|$name|$outcome"$'\n'
  printf '== %s: %s after %d s\n' "$name" $outcome $((SECONDS - started))
  return $status
}

# begin NAME COMMAND...: starts a job with what the jobs of the foreground leave of the processors: many of them keep only one
# busy. One job at a time; `ended` waits for it, prints its log and counts it.
begin() {
  begun=$1
  shift
  local started=$SECONDS
  is_wanted "$begun" || return 0
  set -m  # a process group of its own, which ends as a whole
  (
    renice -n 5 -p $BASHPID >/dev/null
    "$@" >"$logs/$begun.log" 2>&1 </dev/null
    status=$?
    echo $((SECONDS - started)) >"$logs/$begun.seconds"
    exit $status
  ) &
  group=$!
  set +m
}
group=""  # of the job in the background
trap '[ -z "$group" ] || kill -- "-$group" 2>/dev/null' EXIT

ended() {
  local waited=$SECONDS status outcome=passed
  [ -n "$group" ] || return 0
  wait "$group"
  status=$?
  group=""
  printf '\n== %s\n' "$begun"
  cat "$logs/$begun.log"
  if [ $status = 0 ]; then passed=$((passed + 1)); else failed=$((failed + 1)) outcome=FAILED; fi
  table+="$((SECONDS - waited))|$begun|$outcome"$'\n'
  printf '== %s: %s after %d s, of these %d alone\n' "$begun" $outcome "$(cat "$logs/$begun.seconds")" $((SECONDS - waited))
  return $status
}

# tests NAME COMMAND...: a job that runs ctest, whose tests count too.
tests() {
  is_wanted "$1" || return 0
  job "$@"
  local status=$? total bad
  total=$(sed -n 's/.*tests failed out of \([0-9]*\).*/\1/p' "$log" | tail -n 1)
  bad=$(sed -n 's/.*[^0-9]\([0-9][0-9]*\) tests failed out of.*/\1/p' "$log" | tail -n 1)
  passed=$((passed + ${total:-0} - ${bad:-0}))
  failed=$((failed + ${bad:-0}))
  return $status
}

# until_second LAST COMMAND NAME...: a job, or tests, that is left out where the run has taken longer than that: a machine of half
# the usual speed ends in time, and the table tells what it has not read. With --all nothing is left out.
until_second() {
  local last=$1
  shift
  if [ -n "$all" ] || [ "$SECONDS" -lt "$last" ]; then
    "$@"
  else
    table+="0|$2|left out after $SECONDS s"$'\n'
    printf '\n== %s: left out, %d s have passed\n' "$2" "$SECONDS"
  fi
}

# What a failed job printed: of ctest the failed tests alone, of others the end.
explain() {
  if grep -q 'tests failed out of' "$1"; then
    awk '/^ *[0-9]+\/[0-9]+ Test +#[0-9]+: / { shown = /\*\*\*/ } /^ +Start +[0-9]+: / { next } /^[0-9]+% tests passed/ { shown = 1 } shown' "$1" |
      tail -n 400
  else
    tail -n 60 "$1"
  fi
}

# The table of the jobs, then what failed, so that the end of the log explains the failure.
finish() {
  local seconds name outcome
  [ -n "$table" ] || { echo "error: no job is named \"$only\"" >&2; exit 2; }
  printf '\n%-36s %8s %6s\n' job seconds share
  while IFS='|' read -r seconds name outcome; do
    [ -n "$name" ] || continue
    [ "$outcome" != passed ] || outcome=""
    printf '%-36s %8d %5d%% %s\n' "$name" "$seconds" $((100 * seconds / (SECONDS > 0 ? SECONDS : 1))) "$outcome"
  done <<<"$table"
  printf '%-36s %8d\n' "whole run" $SECONDS
  while IFS='|' read -r seconds name outcome; do
    [ "$outcome" = FAILED ] || continue
    printf '\n== %s: FAILED\n' "$name"
    explain "$logs/$name.log"
  done <<<"$table"
  printf '\n%d passed, %d failed\n' "$passed" "$failed"
  [ "$failed" = 0 ]
  exit
}
