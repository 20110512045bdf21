// A record of a mapped block that is changed while it is read may name a vertex of another block. The value of that
// vertex may be copied by another thread at that moment, so the damaged block gets an arbitrary value. A damaged index
// may give any value: only a read outside of the arrays would be an error, and other sanitizers report it.
// NOLINTBEGIN(bugprone-reserved-identifier,cert-dcl37-c,cert-dcl51-cpp): the names are ThreadSanitizer's

// Without the longest history the copy's stack is lost, and its name is unknown.
extern "C" const char* __tsan_default_options() { return "history_size=7"; }

extern "C" const char* __tsan_default_suppressions() {
    return "race:ciel::Field::Data::take_in\n"
           "race:ciel::(anonymous namespace)::copy_block\n"
           "race:ciel::(anonymous namespace)::read_block\n";
}
// NOLINTEND(bugprone-reserved-identifier,cert-dcl37-c,cert-dcl51-cpp)
