import { writeProjectFile, parseProject } from '@botgarten/programs'
import { describe, expect, it } from 'vitest'
import { friendship } from '#storage/testing/sample.ts'
import { remixOf } from './remix.ts'

describe('a remix', () => {
  const project = { ...friendship, progress: { starts: [0], hints: 1 } }
  const remixed = remixOf({ id: 'one', title: 'Slow and safe', project })

  it('knows what it was made from, and has done nothing yet', () => {
    expect(remixed.madeFrom).toEqual([{ id: 'one', title: 'Slow and safe' }])
    expect(remixed).not.toHaveProperty('progress')
    const again = remixOf({ id: 'two', title: 'Rally', project: remixed })
    expect(again.madeFrom).toEqual([
      { id: 'one', title: 'Slow and safe' },
      { id: 'two', title: 'Rally' },
    ])
  })

  it('leaves as a file that any Botgarten opens', () => {
    expect(parseProject(writeProjectFile(remixed))).toEqual(remixed)
  })

  it('keeps the last twenty of a long chain', () => {
    let long = remixed
    for (let at = 0; at < 40; at++) long = remixOf({ id: `${at}`, title: 'x', project: long })
    expect(long.madeFrom).toHaveLength(20)
    expect(long.madeFrom!.at(-1)!.id).toBe('39')
  })
})
