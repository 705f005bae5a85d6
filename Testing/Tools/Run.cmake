# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
#
# For scripts that test by running programs. CHECK is the program CheckPicture.

# run(<command>...): the command, which must succeed.
function (run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE _result)
  if (NOT _result EQUAL 0)
    message(FATAL_ERROR "Failed (${_result}): ${ARGV}")
  endif ()
endfunction ()

# run_for_picture(<file> <command>...): the command with the file's name behind
# it, which must write a picture that shows something.
function (run_for_picture picture)
  file(REMOVE "${picture}")
  run(${ARGN} "${picture}")
  run("${CHECK}" "${picture}")
endfunction ()
