import { describe, expect, test } from 'vitest'
import type { Ask, Reply } from '#storage/ask.ts'
import { Joining } from './joining.svelte.ts'

const away: Reply = { kind: 'away' }
const found = (name: string): Reply => ({ kind: 'done', body: { name } })
const refused = (code: string, seconds = 60): Reply => ({
  ...{ kind: 'refused', status: 429, code },
  facts: { seconds },
})

/** A class that answers when it is told to, and remembers what it was asked. */
function slowClass() {
  const asked: unknown[] = []
  const waiting: ((reply: Reply) => void)[] = []
  const ask: Ask = (_method, _path, body) => {
    asked.push(body)
    // A page that asks for ever would never come back here.
    if (asked.length > 9) throw new Error('The class is asked again and again.')
    return new Promise((resolve) => waiting.push(resolve))
  }
  const answer = async (reply: Reply) => {
    waiting.shift()!(reply)
    for (let turn = 0; turn < 20; turn++) await Promise.resolve()
  }
  return { ask, asked, answer }
}

const types = (joining: Joining, code: string) => (joining.words = code.split(' '))

describe('a child that types the code', () => {
  test.each([['away', away] as const, ['tooManyTries', refused('tooManyTries')] as const])(
    'is told once why the class does not answer: %s',
    async (code, reply) => {
      const { ask, asked, answer } = slowClass()
      const joining = new Joining(ask)
      types(joining, 'kite otter plum rope')
      void joining.look()
      await answer(reply)
      expect(asked).toHaveLength(1)
      expect(joining.refused?.code).toBe(code)
      expect(joining.busy).toBe(false)
      void joining.look()
      expect(asked).toHaveLength(2)
    },
  )

  test('may go on typing while the class is asked: the last code counts', async () => {
    const { ask, asked, answer } = slowClass()
    const joining = new Joining(ask)
    types(joining, 'kite otter plum rope')
    void joining.look()
    types(joining, 'kite otter plum rose')
    await joining.look()
    expect(asked).toEqual([{ code: 'kite otter plum rope' }])
    await answer(refused('noOpenClass'))
    expect(asked).toEqual([{ code: 'kite otter plum rope' }, { code: 'kite otter plum rose' }])
    await answer(found('5b'))
    expect(joining.className).toBe('5b')
    expect(joining.refused).toBeNull()
  })

  test('is not told of a class whose code it has taken away meanwhile', async () => {
    const { ask, answer } = slowClass()
    const joining = new Joining(ask)
    types(joining, 'kite otter plum rope')
    void joining.look()
    joining.words = ['kite', 'otter', '', '']
    await answer(found('5b'))
    expect(joining.className).toBeNull()
  })

  test('waits and tries again by itself after others have guessed too often', async () => {
    const { ask, asked, answer } = slowClass()
    const waits: number[] = []
    const joining = new Joining(ask, (seconds) => Promise.resolve(void waits.push(seconds)))
    types(joining, 'kite otter plum rope')
    const looking = joining.look()
    await answer(refused('tooManyTries', 1))
    expect(joining.refused?.code).toBe('waits')
    await answer(refused('tooManyTries', 2))
    await answer(found('5b'))
    await looking
    expect([joining.className, joining.refused]).toEqual(['5b', null])
    expect(waits).toEqual([1, 2])
    expect(asked).toEqual(Array(3).fill({ code: 'kite otter plum rope' }))
  })

  test('does not ask again for a code that it has changed while it waited', async () => {
    const { ask, asked, answer } = slowClass()
    const joining = new Joining(ask, () => {
      types(joining, 'kite otter plum rose')
      return Promise.resolve()
    })
    types(joining, 'kite otter plum rope')
    void joining.look()
    await answer(refused('tooManyTries', 1))
    expect(asked).toEqual([{ code: 'kite otter plum rope' }, { code: 'kite otter plum rose' }])
    await answer(found('5b'))
    expect(joining.className).toBe('5b')
  })

  test.each([
    [0, 'kite', 0, ['kite', '', '', '']],
    [0, 'kite ', 1, ['kite', '', '', '']],
    [1, 'otter', 1, ['', 'otter', '', '']],
    [1, '', 1, ['', '', '', '']],
    [0, 'kite otter', 1, ['kite', 'otter', '', '']],
    [0, 'kite otter plum ', 3, ['kite', 'otter', 'plum', '']],
    [0, 'kite otter plum rope ', 3, ['kite', 'otter', 'plum', 'rope']],
  ])('types into field %i “%s” and goes on in field %i', (field, text, next, words) => {
    const joining = new Joining(slowClass().ask)
    expect(joining.type(field, text)).toBe(next)
    expect(joining.words).toEqual(words)
  })
})
