/** Why a server did not start, for whoever started it. Words for it: `serve.<problem>` in the command line's. */
export class CannotServe extends Error {
  readonly problem: string
  readonly facts: { readonly [name: string]: string | number }

  constructor(problem: string, facts: CannotServe['facts'] = {}) {
    super(problem)
    this.problem = problem
    this.facts = facts
  }
}

/** The code of an error of the system or the database; its message where it has none. */
export const causeIn = (error: unknown): string => {
  const { code, message = String(error) } = error as NodeJS.ErrnoException
  return code ?? message
}
