# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# run_ranks is the command, up to their number, that starts ranks of MPI, also more than there are cores, and as root.
# Those that wait have to let others run.

execute_process(COMMAND "${MPIEXEC_EXECUTABLE}" --version OUTPUT_VARIABLE version ERROR_VARIABLE version)
set(run_ranks "${MPIEXEC_EXECUTABLE}")
if(version MATCHES "Open MPI|OpenRTE|Open RTE")
  list(APPEND run_ranks --allow-run-as-root --oversubscribe --bind-to none --mca mpi_yield_when_idle 1)
elseif(version MATCHES "HYDRA")
  list(APPEND run_ranks -bind-to none)
else()
  message(STATUS "Ranks are started by ${MPIEXEC_EXECUTABLE} without options: it is neither Open MPI's nor MPICH's")
endif()
list(APPEND run_ranks ${MPIEXEC_NUMPROC_FLAG})
