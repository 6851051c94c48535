const name = 'botgarten-lab'

/** Shows other tabs that a lab is open here. Returns how to let go. Where there are no locks nothing updates by itself. */
export function holdLab(): () => void {
  let letGo = () => {}
  const held = new Promise<void>((done) => (letGo = done))
  const locks = navigator.locks as LockManager | undefined
  void locks?.request(name, { mode: 'shared' }, () => held)
  return letGo
}

/** Does something while no lab is open, in no tab. @returns whether it was done */
export async function whileNoLab(deed: () => Promise<void>): Promise<boolean> {
  return navigator.locks.request(name, { ifAvailable: true }, async (lock) => {
    if (lock) await deed()
    return lock !== null
  })
}
