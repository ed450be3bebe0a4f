// A shared library needs one source of its own; everything else comes from the archive, whole.
typedef int yoke_shared_has_no_code;
