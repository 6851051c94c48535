import { readFileSync } from 'node:fs'
import { createLab, type Document } from '@botgarten/lab'
import type { CardProgram } from '@botgarten/content'
import { paintFloor, type World } from '@botgarten/simulation'
import { describe, expect, it } from 'vitest'
import { factsOf, renewed } from './facts.ts'

const content = new URL('../../../../content/', import.meta.url)
const read = (path: string) => JSON.parse(readFileSync(new URL(path, content), 'utf8')) as unknown
const program = read('cards/network/06-fear/solution.json') as CardProgram
const document: Document = { ...program, world: read('worlds/fear/world.json') as World }

function running() {
  const lab = createLab()
  lab.load(document, paintFloor(document.world), { seed: 1, checks: [] })
  lab.start()
  return lab
}

describe('facts of the views that come every frame', () => {
  it('are the same object while a robot drives on', () => {
    const lab = running()
    const first = factsOf(lab.view(), '')
    lab.advance(1)
    const second = lab.view()
    expect(second.tick).toBe(1)
    const before = factsOf(second, '')
    expect(renewed(first, before)).toBe(before)
    lab.advance(1)
    expect(renewed(before, factsOf(lab.view(), ''))).toBe(before)
  })

  it('are new when a run pauses, when a weight is turned, and for a lab that has none yet', () => {
    const lab = running()
    lab.advance(2)
    const before = factsOf(lab.view(), '')
    expect(renewed(undefined, before)).toBe(before)
    lab.pause()
    const paused = factsOf(lab.view(), '')
    expect(renewed(before, paused)).toBe(paused)
    expect(paused.phase).toBe('paused')
    const [network] = Object.keys(lab.document().brains)
    const { layers } = lab.document().brains[network!]!
    lab.setWeight(network!, layers[0]![0]!.id, layers.at(-1)![0]!.id, 0.35)
    const turned = factsOf(lab.view(), '')
    expect(renewed(paused, turned)).toBe(turned)
  })
})
