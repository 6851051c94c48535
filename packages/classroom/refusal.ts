/** What a request is answered where it may not, cannot or must not. Words for it are the page's, by its code. */
export class Refusal extends Error {
  readonly status: number
  readonly code: string
  readonly facts: { readonly [name: string]: string | number }

  constructor(status: number, code: string, facts: Refusal['facts'] = {}) {
    super(code)
    this.status = status
    this.code = code
    this.facts = facts
  }
}

/** The refusal of a wrong try: the device gets a cookie, under which its wrong tries are counted. */
export class WrongTry extends Refusal {}
