# Add up the closing lines in the logs of tests; fails if a check failed, and
# prints its first line once more, which may be far up by then:
#
#     count-checks.sh LOG...
#
# A log that is not there, since the test could not be built, counts as a check
# that failed.  run-test.sh writes the logs.
for log; do
    grep -sq '^100%' "$log" || grep -sH ':[EF]:\|(status' "$log" >&2
    grep -s '%: Checks:' "$log" || echo '0%: Checks: 1, Failures: 0, Errors: 1'
done | awk -v suites=$# '
    { bad += $5 + $7; good += $3 - $5 - $7 }
    END {
        print "Checks of " suites " suites:"
        printf "%d passed, %d failed\n", good, bad
        exit bad > 0
    }'
