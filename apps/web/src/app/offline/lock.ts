export const LAB_LOCK = 'botgarten-lab'

/** Shows other tabs that a lab is open here. Returns how to let go. Where there are no locks nothing updates by itself. */
export function holdLab(): () => void {
  let letGo = () => {}
  const held = new Promise<void>((done) => (letGo = done))
  const locks = navigator.locks as LockManager | undefined
  void locks?.request(LAB_LOCK, { mode: 'shared' }, () => held)
  return letGo
}
