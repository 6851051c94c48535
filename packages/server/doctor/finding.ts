/** What was found about one thing. Words for it: `doctor.<verdict>` in the command line's. */
export interface Finding<Verdict extends string = string> {
  /** Its thing and how that is, such as `port.taken`. */
  readonly verdict: Verdict
  /** Nothing has to be done. */
  readonly fine: boolean
  readonly facts: { readonly [name: string]: string | number }
}

const found =
  (isFine: boolean) =>
  <const Verdict extends string>(verdict: Verdict, facts: Finding['facts'] = {}): Finding<Verdict> => ({
    verdict,
    fine: isFine,
    facts,
  })

export const fine = found(true)
export const wrong = found(false)
