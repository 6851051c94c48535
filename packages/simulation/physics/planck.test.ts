import { cos, sin } from '@botgarten/numbers'
import { expect, test } from 'vitest'
import { Rot, usesOurMath } from './planck.ts'

const turner = (ofSin: (x: number) => number, ofCos: (x: number) => number) => ({
  s: 0,
  c: 0,
  setAngle(angle: number) {
    this.s = ofSin(angle)
    this.c = ofCos(angle)
  },
})

test('rule 7: the physics library computes with our functions', () => {
  expect(usesOurMath(Rot.identity())).toBe(true)
})

test("rule 7: the engine's own functions would be noticed", () => {
  expect(usesOurMath(turner(sin, cos))).toBe(true)
  expect(usesOurMath(turner(Math.sin, Math.cos))).toBe(false)
})

test('Math is itself again after the library has loaded', () => {
  for (const own of [Math.sin, Math.cos, Math.atan2]) expect(String(own)).toContain('[native code]')
})
