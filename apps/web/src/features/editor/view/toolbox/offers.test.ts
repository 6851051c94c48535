import type * as Blockly from 'blockly/core'
import { describe, expect, it } from 'vitest'
import { wordsIn } from '#words/message.ts'
import { loadExpert } from '../../model/packs.ts'
import { matching, offersOn } from './offers.ts'

const workspace = { getAllBlocks: () => [], getTopBlocks: () => [] } as unknown as Blockly.WorkspaceSvg
const labels = (locale: 'en' | 'de', query: string, all = false) =>
  matching(offersOn(workspace, all, wordsIn(locale)), query).map(({ label }) => label)

describe('looking for a block', () => {
  it('finds a block by a word that stands on it, in each language', () => {
    expect(labels('en', 'if')[0]).toBe('if …')
    expect(labels('de', 'wenn')).toContain('wenn …')
    expect(labels('de', 'wenn')).toContain('wenn … sonst')
  })

  it('finds it by the beginning of a word, in any letter case, and without dots on letters', () => {
    expect(labels('de', 'LAM')[0]).toMatch(/^Lampe/)
    expect(labels('de', 'ruckwarts')[0]).toBe(labels('de', 'rückwärts')[0])
  })

  it('finds a block by what its choices say, after those on which it stands', () => {
    const hits = labels('en', 'backward')
    expect(hits.some((label) => label.startsWith('drive forward'))).toBe(true)
  })

  it('asks for every word', () => {
    for (const label of labels('en', 'drive cm')) expect(label).toMatch(/drive.*cm/)
    expect(labels('en', 'drive xyzzy')).toEqual([])
  })

  it('finds nothing where nothing is asked', () => {
    expect(labels('en', '  ')).toEqual([])
  })

  it('finds more among all blocks, and every one of them by its own words', async () => {
    expect(labels('en', 'list')).toEqual([])
    await loadExpert()
    expect(labels('en', 'list', true).length).toBeGreaterThan(5)
    for (const locale of ['en', 'de'] as const) {
      const offers = offersOn(workspace, true, wordsIn(locale))
      for (const offer of offers)
        expect(matching(offers, offer.label.replaceAll('…', '')), offer.label).toContain(offer)
    }
  })
})
