const every = 500

/** @param {number} pid */
function isAlive(pid) {
  try {
    process.kill(pid, 0)
    return true
  } catch (error) {
    return error.code === 'EPERM'
  }
}

const parent = process.ppid

/**
 * Calls `stop` once the process that started this one has ended. `kill` ends npm and its shell, and neither passes the
 * signal on to what they run.
 * @param {() => void} stop
 */
export function whenParentEnds(stop) {
  const timer = setInterval(() => {
    // On Windows a process keeps the number of a parent that has ended.
    if (process.ppid === parent && isAlive(parent)) return
    clearInterval(timer)
    stop()
  }, every)
  timer.unref()
}
