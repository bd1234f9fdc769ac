// In a file of its own, so that no compiler makes anything but plain bytes of it.
extern const char one_of_many_name[];
const char one_of_many_name[] = "one_of_many_000";
