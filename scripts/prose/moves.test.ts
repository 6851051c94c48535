import { describe, expect, it } from 'vitest'
import { originsOf } from './moves.ts'

const lines = ['Saves a project.', 'Deletes it.', 'Restores it.', 'Lists all.']

describe('a moved file', () => {
  it('has the prose of a deleted file', () => {
    expect(originsOf(new Map([['new.ts', lines]]), new Map([['old.ts', lines]]))).toEqual(
      new Map([['new.ts', 'old.ts']]),
    )
  })

  it('may have other prose in up to half of its lines', () => {
    const changed = ['Stores a project.', 'Removes it.', ...lines.slice(2)]
    expect(originsOf(new Map([['new.ts', changed]]), new Map([['old.ts', lines]])).get('new.ts')).toBe(
      'old.ts',
    )
  })

  it('is a new file if most of its lines are new', () => {
    const changed = ['Stores a project.', 'Removes it.', 'Undoes that.', 'Lists all.']
    expect(originsOf(new Map([['new.ts', changed]]), new Map([['old.ts', lines]]))).toEqual(new Map())
  })

  it('comes from the most similar of several deleted files', () => {
    const similar = ['Stores a project.', ...lines.slice(1)]
    const deleted = new Map([
      ['similar.ts', similar],
      ['same.ts', lines],
    ])
    expect(originsOf(new Map([['new.ts', lines]]), deleted).get('new.ts')).toBe('same.ts')
  })

  it('is one file: a second copy of the same prose is new', () => {
    const added = new Map([
      ['copy.ts', lines.slice(0, 2)],
      ['other.ts', lines.slice(2)],
    ])
    expect(originsOf(added, new Map([['old.ts', lines]])).size).toBe(1)
  })

  it('needs prose', () => {
    expect(originsOf(new Map([['new.ts', []]]), new Map([['old.ts', []]])).size).toBe(0)
  })
})
