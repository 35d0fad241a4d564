import { scriptAddress } from '../../ui/trusted'

/** The page without a network, and its newer versions. */
class Offline {
  /** A newer version is there: this begins it, and loads the page once more. */
  update = $state.raw<(() => void) | null>(null)

  /** Keeps the page, where a browser can. To be called when nothing that is seen is still on its way. */
  async keep(): Promise<void> {
    if (!('serviceWorker' in navigator) || !isSecureContext) return
    const { Workbox } = await import('workbox-window')
    const workbox = new Workbox(scriptAddress(new URL('service-worker.js', location.origin + location.pathname).href))
    workbox.addEventListener('waiting', () => {
      this.update = () => {
        workbox.addEventListener('controlling', () => location.reload())
        workbox.messageSkipWaiting()
      }
    })
    // Where it may not be kept (a private window, no room) the page works all the same.
    const registered = await workbox.register({ immediate: true }).catch(() => undefined)
    // Whoever installs it wants all of it without a network; on others the page in one file is not pressed.
    if (registered && matchMedia('(display-mode: standalone)').matches)
      void workbox.active.then(() => workbox.messageSW({ type: 'KEEP_FILE' }))
  }
}

export const offline = new Offline()
