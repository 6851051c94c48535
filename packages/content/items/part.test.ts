import { expect, test } from 'vitest'
import { content } from '../files.ts'
import type { CardProgram } from '../index.ts'
import { blocksIn } from './blocksIn.ts'
import { partOf } from './part.ts'

const programOf = (card: string, file = 'solution') => content.program(card, file)!
const railway = programOf('railway')
const idsOf = (program: CardProgram) => blocksIn(program).map(({ id }) => id)
const foldedIn = (program: CardProgram) =>
  blocksIn(program).flatMap(({ id, collapsed }) => (collapsed ? [id] : []))

test('without a wish a program is shown as it is', () => {
  expect(partOf(railway, {})).toBe(railway)
})

test('one block is shown with what is in it, and nothing else', () => {
  const ids = idsOf(partOf(railway, { only: 'forever' }))
  expect(ids[0]).toBe('forever')
  expect(ids).toContain('rightC')
  expect(idsOf(railway).filter((id) => !ids.includes(id))).toEqual(
    idsOf(railway).slice(0, idsOf(railway).indexOf('forever')),
  )
})

test('one block is folded, and nothing else is changed', () => {
  const folded = partOf(railway, { fold: 'forever' })
  expect(foldedIn(railway)).toEqual([])
  expect(foldedIn(folded)).toEqual(['forever'])
  expect(idsOf(folded)).toEqual(idsOf(railway))
})

test('a block that is not there is a mistake in the content', () => {
  expect(() => partOf(railway, { fold: 'forvever' })).toThrow('There is no block "forvever".')
})

test('a sheet shows one part for all maps: the part that drives is the same in each program', () => {
  const parts = [railway, ...['forest', 'city'].map((card) => programOf(card)), programOf('railway', 'start')]
  const drives = parts.map((program) => partOf(program, { only: 'forever' }).programs)
  for (const one of drives)
    expect(Object.values(one)[0]!.stacks).toEqual(Object.values(drives[0]!)[0]!.stacks)
})
