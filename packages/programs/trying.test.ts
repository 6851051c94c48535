import { describe, expect, it } from 'vitest'
import { block, programOf, start } from './testing/build.ts'
import { tryingIn } from './trying.ts'

const act = block('ai_try_act')
const sense = (SENSE: string, more = {}) => block('ai_try_senses', { SENSE, SENSORPORT: '2', ...more })
const edgesOf = (...senses: ReturnType<typeof sense>[]) =>
  tryingIn(programOf([start, ...senses, act]))!.trial.edges

describe('states of a robot that learns by trying', () => {
  it('is each of the seven colours, and a touch', () => {
    expect(edgesOf(sense('COLOUR'), sense('TOUCH'))).toEqual([[1, 2, 3, 4, 5, 6, 7], [1]])
  })

  it('is near, middle and far of a distance, from its two edges in rising order', () => {
    expect(edgesOf(sense('DISTANCE', { LOW: '60', HIGH: '20' }))).toEqual([[20, 60]])
    expect(edgesOf(sense('LIGHT', { LOW: '30', HIGH: '30' }))).toEqual([[30]])
  })
})
