# Runs the benchmark with a small mesh and looks for the rows that it must write.
set(csv "${WORK_DIR}/benchmark.csv")
set(markdown "${WORK_DIR}/benchmark.md")
file(REMOVE "${csv}" "${markdown}")
execute_process(
  COMMAND "${BENCHMARK}" --meshes icosphere-10k --cases triangles-cdf,within-deviation-5,smooth-uniform-1,guided --threads 1,2
    --repeats 1 --csv "${csv}" --markdown "${markdown}" --machine "any machine"
  RESULT_VARIABLE result)
if (NOT result EQUAL 0)
  message(FATAL_ERROR "the benchmark failed: ${result}")
endif ()

# check_rows(FILE COUNT REGEX): the file has so many lines that match.
function (check_rows file count regex)
  file(STRINGS "${file}" rows REGEX "${regex}" ENCODING UTF-8)
  list(LENGTH rows found)
  if (NOT found EQUAL count)
    message(SEND_ERROR "${file}: ${found} instead of ${count} lines match ${regex}")
  endif ()
endfunction ()

set(number "[0-9.]+")
set(stages "${number}(,${number})+")
set(case "${number},${number},${number},[0-9]+,${stages},[0-9.]*,0[.][0-9]+,0[.][0-9]+")
check_rows("${csv}" 11 ",") # the heading, and 5 cases with 2 numbers of threads
foreach (threads RANGE 1 2)
  check_rows("${csv}" 1 "^icosphere-10k,10242,${threads},windowed-sinc,${number},${number},1[.]0+,,")
  check_rows("${csv}" 1 "^icosphere-10k,10242,${threads},triangles-cdf,${case}$")
  check_rows("${csv}" 1 "^icosphere-10k,10242,${threads},within-deviation-5,${case}$")
  check_rows("${csv}" 1 "^icosphere-10k,10242,${threads},smooth-uniform-1,${case}$")
  check_rows("${csv}" 1 "^icosphere-10k,10242,${threads},guided,${case}$")
endforeach ()

check_rows("${markdown}" 1 "any machine")
check_rows("${markdown}" 2 "^## Time on [12] thread")
check_rows("${markdown}" 2 "^[|] icosphere-10k [|] 10242 [|] ${number} [|] ${number} [|] ${number} [|]$")
check_rows("${markdown}" 2 "^[|] mesh [|] reading [|] setup [|] solving [|] filtering [|] following [|] passes [|] worst [|] comparing [|] writing [|]$")
check_rows("${markdown}" 1 "^## Iterations$")
