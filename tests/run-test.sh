# Run a test, put all that it prints into a log, and print its closing line:
#
#     EMULATOR=words run-test.sh PROGRAM NAME LOG
#
# The EMULATOR, if any, runs the program of another machine.
# It counts the checks, "100%: Checks: 12, Failures: 0, Errors: 0".  A test that
# breaks off or checks nothing counts as a check that failed.  The whole log is
# printed unless all checks passed.
set -u
program=$1 name=$2 log=$3

status=0
${EMULATOR-} "$program" >"$log" 2>&1 || status=$?

failed='Failures: [1-9]\|Errors: [1-9]'
if ! grep -q "$failed" "$log" &&
    ! { [ $status = 0 ] && grep -q 'Checks: [1-9]' "$log"; }; then
    echo "0%: Checks: 1, Failures: 0, Errors: 1 (status $status)" >>"$log"
fi

closing=$(grep '%: Checks:' "$log" | tail -n 1)
case $closing in
100%*) ;;
*) cat "$log" ;;
esac
printf '%-32s %s\n' "$name" "$closing"
