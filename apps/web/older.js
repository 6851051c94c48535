// Runs before all other scripts, also in browsers that cannot run those: only the JavaScript of 2009 is used (lint).
// older.ts puts it into every document, after the message that it shows.
;(function () {
  var box = document.getElementById('older')

  function show() {
    box.hidden = false
    box.getElementsByTagName('button')[0].onclick = function () {
      box.hidden = true
    }
  }

  /** Lookbehind came with Safari 16.4, toSorted with Firefox 115, color-mix with Chrome and Edge 111 (packages/browsers). */
  function isOld() {
    try {
      new RegExp('(?<=a)b')
    } catch (error) {
      return true
    }
    return !Array.prototype.toSorted || !window.CSS || !CSS.supports('color', 'color-mix(in srgb, red, red)')
  }

  function failed() {
    setTimeout(function () {
      if (!document.getElementsByTagName('main').length) show()
    }, 3000)
  }

  if (isOld()) return show()
  window.addEventListener('error', failed)
  window.addEventListener('unhandledrejection', failed)
})()
