import { expect, it } from 'vitest'
import { highlighted, lineByKey } from './highlighted.ts'

const kinds = (code: string) =>
  highlighted(code).map((line) =>
    line.filter(({ kind }) => kind !== '').map(({ text, kind }) => `${kind} ${text}`),
  )

it('a line falls into pieces that say what they are', () => {
  expect(kinds('if speed(30) > 2.5:  # fast\n')).toEqual([
    ['keyword if', 'name speed', 'number 30', 'number 2.5', 'note # fast'],
  ])
})

it('texts and words of Python are told apart', () => {
  expect(kinds('return "if"')).toEqual([['keyword return', 'text "if"']])
})

it('words that define or import are words of Python, names that are defined are plain', () => {
  expect(kinds('import a\ndef go(far):\n    class Bo: x = None')).toEqual([
    ['keyword import'],
    ['keyword def', 'name go'],
    ['keyword class', 'keyword None'],
  ])
})

it('nothing is lost or added', () => {
  const code = '# ä\n\n\ndef f(x):\n    return x + "\\n"\n'
  const text = highlighted(code)
    .map((line) => line.map((piece) => piece.text).join(''))
    .join('\n')
  expect(`${text}\n`).toBe(code)
})

it('keys lead from line to line, and not beyond the first and the last', () => {
  const from = (line: number) =>
    ['ArrowUp', 'ArrowDown', 'PageDown', 'Home', 'End'].map((key) => lineByKey(key, line, 20))
  expect(from(2)).toEqual([1, 3, 17, 0, 19])
  expect(from(0)).toEqual([0, 1, 15, 0, 19])
  expect(from(19)).toEqual([18, 19, 19, 0, 19])
  expect(lineByKey('a', 2, 20)).toBeUndefined()
})
