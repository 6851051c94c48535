import type { Finding } from '@botgarten/classroom'

const found =
  (isFine: boolean) =>
  <const Verdict extends string>(verdict: Verdict, facts: Finding['facts'] = {}): Finding<Verdict> => ({
    verdict,
    fine: isFine,
    facts,
  })

export const fine = found(true)
export const wrong = found(false)
