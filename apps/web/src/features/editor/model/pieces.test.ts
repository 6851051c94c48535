import { definitions } from '@botgarten/blocks'
import { describe, expect, it } from 'vitest'
import { piecesOf } from './pieces.ts'
import { wordsIn } from '#words/message.ts'

describe('the rows of a block', () => {
  it('are cut at their placeholders, in the order of the language', () => {
    const words = (_key: string, facts: Readonly<Record<string, unknown>> = {}) =>
      `wenn ${String(facts['ICON'])} gedrückt`
    expect(piecesOf('x', ['ICON'], words)).toEqual([{ text: 'wenn' }, { name: 'ICON' }, { text: 'gedrückt' }])
  })

  it.each(Object.values(definitions).map(({ type, look }) => [type, look] as const))(
    'of %s hold each of its fields and inputs once, in both languages',
    (_type, look) => {
      const shown = look.fields.filter(({ kind }) => kind !== 'hidden')
      const names = [...shown, ...look.inputs].map(({ name }) => name)
      for (const locale of ['en', 'de'] as const) {
        const pieces = look.rows.flatMap((key) => piecesOf(key, [...names, 'ICON'], wordsIn(locale)))
        const placed = pieces.flatMap((piece) =>
          'name' in piece && piece.name !== 'ICON' ? [piece.name] : [],
        )
        expect([...placed].sort()).toEqual([...names].sort())
      }
    },
  )
})
