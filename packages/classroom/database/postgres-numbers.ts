import pg from 'pg'

const int8 = 20
const numeric = 1700

/** PostgreSQL gives wide numbers and sums as text; all of ours fit a double. */
export const asNumbers = {
  getTypeParser: (id: number, format?: 'text' | 'binary'): unknown => {
    if (id === int8 || id === numeric) return Number
    const usual: unknown = pg.types.getTypeParser(id, format)
    return usual
  },
}
