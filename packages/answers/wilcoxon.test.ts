import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import reference from './reference/statistics.json' with { type: 'json' }
import { signedRank } from './wilcoxon.ts'

describe("Wilcoxon's signed-rank test", () => {
  it.each(reference.tests)(
    'gives what SciPy gives for $differences',
    ({ differences, n, plus, minus, p, r }) => {
      const found = signedRank(differences)!
      expect([found.n, found.plus, found.minus]).toEqual([n, plus, minus])
      expect(Math.abs(found.p! - p)).toBeLessThan(1e-12)
      expect(Math.abs(found.r - r)).toBeLessThan(1e-12)
    },
  )

  it('says that five pairs cannot come below 0.05, and six can', () => {
    expect(signedRank([1, 2, 3, 4, 5])!.smallest).toBe(0.0625)
    expect(signedRank([1, 2, 3, 4, 5, 6])!.smallest).toBe(0.03125)
  })

  it('says nothing where no pair differs', () => {
    expect(signedRank([0, 0, 0])).toBeNull()
  })

  it('counts no p for more pairs than a class has ever had', () => {
    expect(signedRank(Array<number>(401).fill(1))!.p).toBeNull()
    expect(signedRank(Array<number>(400).fill(1))!.p).toBeGreaterThan(0)
  })

  it('turns its effect and keeps its p when before and after change places', () => {
    const differences = fc.array(fc.integer({ min: -3, max: 3 }), { minLength: 1, maxLength: 40 })
    fc.assert(
      fc.property(differences, (all) => {
        const [found, turned] = [signedRank(all), signedRank(all.map((one) => -one))]
        if (!found || !turned) {
          expect(turned).toBe(found)
          return
        }
        expect(turned.r).toBeCloseTo(-found.r, 12)
        expect(turned.p).toBe(found.p)
        expect(found.p!).toBeGreaterThanOrEqual(found.smallest - 1e-15)
        expect(found.p!).toBeLessThanOrEqual(1)
      }),
    )
  })
})
