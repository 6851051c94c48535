import type * as Blockly from 'blockly/core'
import { expect, it } from 'vitest'
import { loadExpert } from '../../model/packs.ts'
import { BlockSearch } from './block-search.svelte.ts'

const workspace = { getAllBlocks: () => [], getTopBlocks: () => [] } as unknown as Blockly.WorkspaceSvg

function searchFor(query: string) {
  const search = new BlockSearch(workspace, false)
  search.ask(query)
  return search
}

it('nothing is found before something is asked, and spaces ask nothing', () => {
  expect(searchFor(' ').hits).toEqual([])
  expect(searchFor(' wait ').asked).toBe('wait')
})

it('arrows go round the hits', () => {
  const search = searchFor('e')
  search.moves('ArrowUp')
  expect(search.at).toBe(search.hits.length - 1)
  search.moves('ArrowDown')
  expect(search.at).toBe(0)
})

it('whole pages stop at the first and the last hit', () => {
  const search = searchFor('e')
  for (let k = 0; k <= search.hits.length / 6; k++) search.moves('PageDown')
  expect(search.at).toBe(search.hits.length - 1)
  for (let k = 0; k <= search.hits.length / 6; k++) search.moves('PageUp')
  expect(search.at).toBe(0)
})

it('another query begins at its first hit', () => {
  const search = searchFor('e')
  search.moves('ArrowDown')
  search.ask('a')
  expect(search.at).toBe(0)
})

it('keys that move nothing, and keys in an empty list, are left alone', () => {
  expect(searchFor('e').moves('Home')).toBe(false)
  expect(searchFor('qqqq').moves('ArrowDown')).toBe(false)
})

it('among all blocks more is found', async () => {
  await loadExpert()
  const search = searchFor('e')
  const before = search.hits.length
  search.lookInAll()
  expect(search.hits.length).toBeGreaterThan(before)
})
