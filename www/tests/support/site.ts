/** Where the tests serve the page: below a sub-path, as on many static hosts. */
export const SITE = `http://127.0.0.1:${process.env.FORAGE_TEST_PORT ?? '4187'}/lectures/forage/`
