/** How a pack is put together. */
export interface PackOptions {
  readonly children: number
  /** Answers lie behind everything, are in a file of their own, or are this file. */
  readonly answers: 'with' | 'apart' | 'only'
}

const usual = 24
const most = 99

/** Reads `?children=24&answers=with|apart|only`; what cannot be is as usual. */
export function packOptionsIn(search: Pick<URLSearchParams, 'get'>): PackOptions {
  const children = Number(search.get('children') ?? usual)
  const answers = search.get('answers')
  return {
    children: Number.isInteger(children) && children >= 1 && children <= most ? children : usual,
    answers: answers === 'apart' || answers === 'only' ? answers : 'with',
  }
}
