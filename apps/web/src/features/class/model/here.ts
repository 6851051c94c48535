// Who sits at this device: asked at every start, after ten minutes without a key, and again by pictures after a lesson.

/** A child who answers after so long is asked for the pictures. */
const lesson = 90 * 60_000
/** After so long without a key or a finger it may be somebody else. */
const quiet = 10 * 60_000

const tab = 'botgarten.here'
const proven = 'botgarten.proven'

const read = (store: 'sessionStorage' | 'localStorage', key: string): string | null => {
  try {
    return globalThis[store].getItem(key)
  } catch {
    return null
  }
}
const write = (store: 'sessionStorage' | 'localStorage', key: string, text: string | null): void => {
  try {
    if (text === null) globalThis[store].removeItem(key)
    else globalThis[store].setItem(key, text)
  } catch {
    // It is asked once more then.
  }
}

/** The pupil has joined, or shown the pictures: nothing is asked in this tab, and for a lesson "yes" is enough. */
export function arrive(pupil: string, as: 'new' | 'back'): void {
  write('sessionStorage', tab, as === 'back' ? `back ${pupil}` : pupil)
  prove(pupil)
}

export const prove = (pupil: string, now = Date.now()): void =>
  write('localStorage', proven, `${pupil} ${now}`)

/** Has this pupil shown the pictures on this device within a lesson? A clock that was set back proves nothing. */
export function isProven(pupil: string, now = Date.now()): boolean {
  const [of, at] = (read('localStorage', proven) ?? '').split(' ')
  const since = now - Number(at)
  return of === pupil && since >= 0 && since < lesson
}

/** How a page begins: it `asks`, the child is `here` already, or has come `back` just now. */
export function beginning(pupil: string): 'asks' | 'here' | 'back' {
  const noted = read('sessionStorage', tab)
  if (noted === `back ${pupil}`) return 'back'
  return noted === pupil ? 'here' : 'asks'
}

/** In this tab it is not asked again. */
export const stayHere = (pupil: string): void => write('sessionStorage', tab, pupil)

/** Nothing of the former child is left but what its own database holds. */
export function forgetHere(): void {
  write('sessionStorage', tab, null)
  write('localStorage', proven, null)
}

/** Calls back after ten minutes without a key or a finger, once, also where the laptop slept meanwhile. Returns how to stop. */
export function whenQuiet(quietNow: () => void, wait = quiet): () => void {
  let last = Date.now()
  const look = () => {
    if (Date.now() - last < wait) return false
    stop()
    quietNow()
    return true
  }
  const touched = () => look() || (last = Date.now())
  const timer = setInterval(look, wait / 40)
  const kinds = ['keydown', 'pointerdown'] as const
  for (const kind of kinds) addEventListener(kind, touched, { capture: true, passive: true })
  const stop = () => {
    clearInterval(timer)
    for (const kind of kinds) removeEventListener(kind, touched, { capture: true })
  }
  return stop
}
