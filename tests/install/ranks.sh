# Where yoke-mpi is installed: a study on two ranks has the bytes of one process. Exit code 0: it has.
set -eu
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_btl=self,vader
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
study="yoke study /usr/share/yoke/examples/four-bar.yaml --vary a=39mm:41mm:500 --over theta2=0:360deg --steps 36 --of theta4 --quiet"
yoke --version | grep -q '^yoke-mpi .*Open MPI' || { echo "yoke --version does not name yoke-mpi" >&2; exit 1; }
$study -o "$work/alone.csv"
mpirun -n 2 $study -o "$work/shared.csv"
cmp "$work/alone.csv" "$work/shared.csv"
echo "two ranks: the same bytes"
