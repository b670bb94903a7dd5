"""Knows which header of the standard library declares a name, and which names a text uses.

Standard headers include other standard headers, and which ones differs between libraries and versions.
A file that relies on this may not compile with another compiler. Therefore a file includes the headers
of the names that it uses, directly or through headers of this project.
"""

import re

from lint_report import blanked

# The headers with the names that they declare, without std::. A name that several headers declare is
# listed with each of them, and any of them suffices. Names that nearly every header declares, such as
# std::size_t, are left out.
HEADERS = {
    "algorithm": """
        adjacent_find all_of any_of binary_search clamp copy copy_backward copy_if copy_n count
        count_if equal equal_range fill fill_n find find_end find_first_of find_if find_if_not
        for_each for_each_n generate generate_n includes inplace_merge is_heap is_partitioned
        is_permutation is_sorted is_sorted_until lexicographical_compare lower_bound make_heap max
        max_element merge min min_element minmax minmax_element mismatch move_backward
        next_permutation none_of nth_element partial_sort partial_sort_copy partition
        partition_point pop_heap prev_permutation push_heap remove_copy remove_copy_if remove_if
        replace replace_copy replace_if reverse reverse_copy rotate rotate_copy sample search
        search_n set_difference set_intersection set_union shift_left shift_right shuffle sort
        sort_heap stable_partition stable_sort swap_ranges transform unique unique_copy upper_bound
        ranges::sort ranges::copy ranges::find ranges::find_if ranges::any_of ranges::all_of
        ranges::none_of ranges::count ranges::count_if ranges::max ranges::min ranges::fill""",
    "any": "any any_cast make_any",
    "array": "array to_array",
    "atomic": "atomic atomic_bool atomic_flag atomic_int atomic_ref atomic_thread_fence memory_order",
    "barrier": "barrier",
    "bit": """bit_cast bit_ceil bit_floor bit_width countl_one countl_zero countr_one countr_zero
        endian has_single_bit popcount rotl rotr""",
    "bitset": "bitset",
    "cctype": """isalnum isalpha isblank iscntrl isdigit isgraph islower isprint ispunct isspace
        isupper isxdigit tolower toupper""",
    "charconv": "chars_format from_chars from_chars_result to_chars to_chars_result",
    "chrono": "chrono chrono_literals",
    "clocale": "lconv localeconv setlocale",
    "cmath": """abs acos acosh asin asinh atan atan2 atanh cbrt ceil copysign cos cosh erf erfc exp
        exp2 expm1 fabs fdim floor fma fmax fmin fmod fpclassify frexp hypot ilogb isfinite isinf
        isnan isnormal ldexp lerp lgamma llrint llround log log10 log1p log2 logb lrint lround modf
        nan nanf nearbyint nextafter pow remainder remquo rint round scalbn signbit sin sinh sqrt
        tan tanh tgamma trunc""",
    "compare": "partial_ordering strong_ordering weak_ordering",
    "complex": "complex",
    "concepts": """convertible_to derived_from floating_point integral invocable same_as
        signed_integral unsigned_integral""",
    "condition_variable": "condition_variable condition_variable_any cv_status",
    "csignal": "raise sig_atomic_t signal",
    "cstdarg": "va_list",
    "cstddef": "byte max_align_t ptrdiff_t",
    "cstdint": """int16_t int32_t int64_t int8_t intmax_t intptr_t uint16_t uint32_t uint64_t
        uint8_t uintmax_t uintptr_t""",
    "cstdio": """FILE fclose feof ferror fflush fgetc fgets fopen fprintf fputc fputs fread freopen
        fscanf fseek ftell fwrite getchar perror printf putchar puts remove rename rewind scanf
        setvbuf snprintf sprintf sscanf tmpfile ungetc vfprintf vprintf vsnprintf""",
    "cstdlib": """_Exit abort abs aligned_alloc at_quick_exit atexit atof atoi atol calloc div exit
        free getenv labs ldiv llabs malloc qsort quick_exit rand realloc srand strtod strtof strtol
        strtold strtoll strtoul strtoull system""",
    "cstring": """memchr memcmp memcpy memmove memset strcat strchr strcmp strcpy strcspn strerror
        strlen strncmp strncpy strpbrk strrchr strspn strstr strtok""",
    "ctime": "clock clock_t difftime gmtime localtime mktime strftime time time_t tm",
    "deque": "deque",
    "exception": """current_exception exception exception_ptr get_terminate make_exception_ptr
        nested_exception rethrow_exception set_terminate terminate throw_with_nested
        uncaught_exceptions""",
    "filesystem": "filesystem",
    "fstream": "filebuf fstream ifstream ofstream",
    "functional": """bind bit_and bit_or divides equal_to function greater greater_equal hash invoke
        less less_equal logical_and logical_not logical_or mem_fn minus modulus multiplies negate
        not_equal_to not_fn plus placeholders cref ref reference_wrapper""",
    "future": "async future future_error future_status launch packaged_task promise shared_future",
    "initializer_list": "initializer_list",
    "iomanip": "get_time put_time quoted setfill setprecision setw",
    "iostream": "cerr cin clog cout",
    "istream": "istream ws",
    "iterator": """advance back_insert_iterator back_inserter distance front_inserter inserter
        istream_iterator istreambuf_iterator make_move_iterator make_reverse_iterator next
        ostream_iterator ostreambuf_iterator prev reverse_iterator""",
    "latch": "latch",
    "limits": "numeric_limits",
    "list": "list",
    "locale": "locale",
    "map": "map multimap",
    "memory": """addressof align allocate_shared allocator allocator_traits assume_aligned
        construct_at const_pointer_cast default_delete destroy destroy_at dynamic_pointer_cast
        enable_shared_from_this make_shared make_unique make_unique_for_overwrite pointer_traits
        shared_ptr static_pointer_cast uninitialized_copy uninitialized_fill unique_ptr weak_ptr""",
    "mutex": """call_once defer_lock lock_guard mutex once_flag recursive_mutex scoped_lock
        timed_mutex try_to_lock unique_lock""",
    "new": "align_val_t bad_alloc bad_array_new_length get_new_handler launder nothrow set_new_handler",
    "numbers": "numbers",
    "numeric": """accumulate adjacent_difference exclusive_scan gcd inclusive_scan inner_product iota
        lcm midpoint partial_sum reduce transform_reduce""",
    "optional": "bad_optional_access in_place make_optional nullopt nullopt_t optional",
    "ostream": "endl flush ostream",
    "queue": "priority_queue queue",
    "random": """bernoulli_distribution default_random_engine discrete_distribution
        exponential_distribution generate_canonical mt19937 mt19937_64 normal_distribution
        poisson_distribution random_device seed_seq uniform_int_distribution
        uniform_real_distribution""",
    "ratio": "milli micro nano ratio",
    "regex": """cmatch regex regex_constants regex_error regex_match regex_replace regex_search
        smatch sregex_iterator sregex_token_iterator""",
    "semaphore": "binary_semaphore counting_semaphore",
    "set": "multiset set",
    "shared_mutex": "shared_lock shared_mutex",
    "source_location": "source_location",
    "span": "as_bytes as_writable_bytes dynamic_extent span",
    "sstream": "istringstream ostringstream stringbuf stringstream",
    "stack": "stack",
    "stdexcept": """domain_error invalid_argument length_error logic_error out_of_range
        overflow_error range_error runtime_error underflow_error""",
    "stop_token": "nostopstate stop_callback stop_source stop_token",
    "streambuf": "streambuf",
    "string": """basic_string char_traits getline stod stof stoi stol stold stoll stoul stoull string
        string_literals to_string u16string u32string u8string wstring""",
    "string_view": "basic_string_view string_view string_view_literals u8string_view wstring_view",
    "system_error": """errc error_category error_code error_condition generic_category
        make_error_code make_error_condition system_category system_error""",
    "thread": "jthread this_thread thread",
    "tuple": """apply forward_as_tuple ignore make_from_tuple make_tuple tie tuple tuple_cat
        tuple_element_t tuple_size_v""",
    "type_traits": """add_const_t add_pointer_t alignment_of common_type_t conditional conditional_t
        decay_t enable_if enable_if_t false_type integral_constant invoke_result_t
        is_arithmetic_v is_base_of_v is_class_v is_const_v is_constant_evaluated is_constructible_v
        is_convertible_v is_default_constructible_v is_empty_v is_enum_v is_floating_point_v
        is_integral_v is_invocable_r_v is_invocable_v is_pointer_v is_same is_same_v is_signed_v
        is_standard_layout_v is_trivial_v is_trivially_copyable_v is_trivially_destructible_v
        is_unsigned_v is_void_v make_signed_t make_unsigned_t remove_const_t remove_cv_t
        remove_cvref_t remove_pointer_t remove_reference_t true_type type_identity type_identity_t
        underlying_type_t void_t""",
    "typeindex": "type_index",
    "typeinfo": "bad_cast type_info",
    "unordered_map": "unordered_map unordered_multimap",
    "unordered_set": "unordered_multiset unordered_set",
    "utility": """as_const cmp_equal cmp_greater cmp_greater_equal cmp_less cmp_less_equal declval
        exchange forward in_range index_sequence integer_sequence make_index_sequence make_pair
        move move_if_noexcept pair piecewise_construct swap to_underlying""",
    "variant": "get_if holds_alternative monostate variant visit",
    "vector": "vector",
}
# Further names that several headers declare according to the standard.
ALSO = {
    "erase_if": "vector string map set deque list unordered_map unordered_set",
    "erase": "vector string deque list",
    "remove": "algorithm cstdio",
    "begin": "iterator array string string_view vector span map set deque list regex",
    "end": "iterator array string string_view vector span map set deque list regex",
    "size": "iterator array string string_view vector span map set deque list regex",
    "ssize": "iterator array string string_view vector span map set deque list regex",
    "data": "iterator array string string_view vector span map set deque list regex",
    "swap": "utility algorithm",
    "ios": "ios istream ostream iostream fstream sstream",
    "istream": "istream iostream fstream sstream",
    "ostream": "ostream iostream fstream sstream",
    "endl": "ostream iostream fstream sstream",
    "ws": "istream iostream fstream sstream",
    "exception": "exception stdexcept new",
    "initializer_list": "initializer_list vector string map set algorithm array",
}


def _declaring():
    found = {}
    for header, names in HEADERS.items():
        for name in names.split():
            found.setdefault(name, set()).add(header)
    for name, headers in ALSO.items():
        found.setdefault(name, set()).update(headers.split())
    return found


DECLARING = _declaring()
# These headers declare only functions. A file that calls such a function must include its header
# itself or in the header of the same name. All other headers may also come through another header of
# this project.
OF_FUNCTIONS = {"algorithm", "bit", "cctype", "charconv", "cmath", "cstring", "numeric"}
_TEXT = re.compile(r'//[^\n]*|/\*.*?\*/|R"\(.*?\)"|"(?:\\.|[^"\\\n])*"', re.S)
_NAME = re.compile(r"\bstd::((?:ranges::)?\w+)")


def names_used(text):
    """Yields (position, name) of the first use of each name of std:: outside comments and strings."""
    seen = set()
    code = blanked(_TEXT, text)
    for match in _NAME.finditer(code):
        if match.group(1) not in seen:
            seen.add(match.group(1))
            yield match.start(), match.group(1)


def missing(text, own, reached):
    """Yields (position, name, headers of which one is needed) of each name of `text` that no header
    brings on purpose. `own` holds the headers that the file and its own header include. `reached`
    holds also the headers that these include."""
    for position, name in names_used(text):
        headers = DECLARING.get(name, set())
        if headers and not headers & (own if headers <= OF_FUNCTIONS else reached):
            yield position, name, sorted(headers)
