import { expect, it } from 'vitest'
import { highlighted } from './highlighted.ts'

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

it('nothing is lost or added', () => {
  const code = '# ä\n\n\ndef f(x):\n    return x + "\\n"\n'
  const text = highlighted(code)
    .map((line) => line.map((piece) => piece.text).join(''))
    .join('\n')
  expect(`${text}\n`).toBe(code)
})
