import * as v from 'valibot'

/** The pupil of a class who uses this device now. What is saved here is theirs: nobody else sees or sends it. */
export interface Account {
  readonly pupil: string
  readonly class: string
  readonly nickname: string
  readonly className: string
}

const id = v.pipe(v.string(), v.regex(/^[\w-]{1,64}$/))
const text = v.pipe(v.string(), v.maxLength(100))
const schema = v.object({ pupil: id, class: id, nickname: text, className: text })

const key = 'botgarten.class'

/** The device's record of its pupil: the cheap sign by which a page knows that it belongs to a class. */
function readAccount(): Account | null {
  try {
    const found = v.safeParse(schema, JSON.parse(localStorage.getItem(key) ?? 'null'))
    return found.success ? found.output : null
  } catch {
    return null
  }
}

/** For as long as a page is open it works for the pupil of its start: another one is another page. */
const ofThisPage = readAccount()

export const account = (): Account | null => ofThisPage

/** Is the device another pupil's by now than this page is? */
const accountHasChanged = (): boolean => readAccount()?.pupil !== ofThisPage?.pupil

/** From the next page on the device is this pupil's. @throws where the browser keeps nothing */
export function setAccount(next: Account | null): void {
  if (next) localStorage.setItem(key, JSON.stringify(next))
  else localStorage.removeItem(key)
}

/** Calls back when another tab has made the device somebody else's. Returns how to stop. */
export function whenAccountChanges(changed: () => void): () => void {
  const listener = (event: StorageEvent) => {
    if ((event.key === key || event.key === null) && accountHasChanged()) changed()
  }
  addEventListener('storage', listener)
  return () => removeEventListener('storage', listener)
}

/** A name in the browser's storage that each pupil has of their own; without a pupil it stays as it is. */
export const ownName = (name: string): string => (ofThisPage ? `${name}-${ofThisPage.pupil}` : name)
