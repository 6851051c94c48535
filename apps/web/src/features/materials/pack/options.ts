/** How a pack is put together. */
export interface PackOptions {
  readonly children: number
  /** Answers lie behind everything, are in a file of their own, or are this file. */
  readonly answers: 'with' | 'apart' | 'only'
  /** Of the class: sheets with reading levels are those for it; null: those in the middle. */
  readonly grade: number | null
}

const usual = 24
const most = 99

/** Reads `?children=24&answers=with|apart|only&grade=4`; what cannot be is as usual. */
export function packOptionsIn(search: Pick<URLSearchParams, 'get'>): PackOptions {
  const children = Number(search.get('children') ?? usual)
  const answers = search.get('answers')
  const grade = Number(search.get('grade') ?? 0)
  return {
    children: Number.isInteger(children) && children >= 1 && children <= most ? children : usual,
    grade: Number.isInteger(grade) && grade >= 1 && grade <= 13 ? grade : null,
    answers: answers === 'apart' || answers === 'only' ? answers : 'with',
  }
}
