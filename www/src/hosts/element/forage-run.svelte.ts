import { mount, unmount } from 'svelte'
import { STANDARD } from '../../catalogue/standard'
import { host } from '../../engine/host'
import { closest, language } from '../../locales/language.svelte'
import type { Controls } from '../../catalogue/embedding'
import { optionsOf } from '../../rooms/embed/options'
import type { RunEvent, RunState } from 'forage-lab/embed'
import { obey, stateOf, tell } from '../../rooms/embed/remote.svelte'
import { attributesOf } from '../../stores/attributes'
import { Lab } from '../../stores/lab.svelte'
import { stillness, Theme } from '../../stores/theme.svelte'
import { firstLanguage, isChosen } from '../../stores/language'
import { lessonIn, type Place } from '../../stores/lesson-address'
import { linkOf, SETUP } from './link'
import Run from './Run.svelte'

/** The styles of all that an element shows: put there while building. */
declare const ELEMENT_STYLES: string
const HOST =
  ':host{display:block;position:relative;width:100%;min-width:320px;min-height:240px;aspect-ratio:3/2;overflow:hidden}:host([hidden]){display:none}'

let shared: CSSStyleSheet | undefined
/** An element has chosen the language of the document. */
let spoken = false

/** All elements of a page share one sheet. */
function sheet(): CSSStyleSheet {
  if (shared) return shared
  shared = new CSSStyleSheet()
  shared.replaceSync(HOST + ELEMENT_STYLES)
  return shared
}

/** A run that is shown, and what ends it. */
interface Shown {
  lab: Lab
  end(): void
}

/**
 * `<forage-run>`: a run on a page. It begins when it comes into view, and pauses while it is out of sight.
 *
 * Attributes: `src` (a link of a run, or `#lesson=` and a lesson’s name), or `planner`, `scene`, `seed`, `params` (`w=0.7; c1=2`) and `at`; `layers` (`best,-particles`);
 * `controls` (`none`, `play`, `full`), `theme` (`light`, `dark`, `system`), `lang` (`en`, `zh-CN`), `autoplay`.
 */
export class ForageRun extends HTMLElement {
  static readonly observedAttributes = [...SETUP, 'controls', 'theme', 'lang']

  private shown: Shown | undefined
  private readonly look = $state<{ controls: Controls; lesson: Place | null }>({ controls: 'play', lesson: null })
  private readonly theme = new Theme()
  private visible = false
  /** It goes on when it comes into view. */
  private resumes = false
  /** Several attributes that change at once are one change. */
  private changed = false
  private readonly sight = new IntersectionObserver((entries) => this.see(entries.at(-1)?.isIntersecting ?? false))

  connectedCallback(): void {
    if (!this.shadowRoot) this.attachShadow({ mode: 'open' }).adoptedStyleSheets = [sheet()]
    this.dress()
    this.sight.observe(this)
  }

  disconnectedCallback(): void {
    this.sight.unobserve(this)
    // One that is only moved is connected again at once.
    queueMicrotask(() => {
      if (this.isConnected) return
      this.shown?.end()
      this.shown = undefined
    })
  }

  attributeChangedCallback(name: string, before: string | null, after: string | null): void {
    if (before === after) return
    if (name === 'lang') {
      void this.speak()
      return
    }
    if (name === 'controls' || name === 'theme') {
      this.dress()
      return
    }
    if (!this.shown || this.changed) return
    this.changed = true
    queueMicrotask(() => {
      this.changed = false
      void this.openAgain()
    })
  }

  /** Where the run is; undefined before it has come into view. */
  get state(): RunState | undefined {
    return this.shown && stateOf(this.shown.lab)
  }

  play(): void {
    obey(this.begun(), { is: 'play' })
  }

  pause(): void {
    this.resumes = false
    obey(this.begun(), { is: 'pause' })
  }

  /** Steps so many iterations on, or back. */
  step(by = 1): void {
    obey(this.begun(), { is: 'step', by })
  }

  /** Goes to an iteration; `Infinity`: to the end. */
  seek(to: number): void {
    obey(this.begun(), { is: 'seek', to })
  }

  private begun(): Lab {
    this.shown ??= this.begin()
    return this.shown.lab
  }

  private dress(): void {
    const { controls, theme } = optionsOf((name) => this.getAttribute(name))
    this.look.controls = controls
    this.theme.choice = theme
  }

  /** A document has one language: that which an element asks for, or else that of a link or the browser. */
  private async speak(): Promise<void> {
    const asked = closest(this.getAttribute('lang') ?? '')
    // The first one decides where none asks.
    if (asked === undefined && spoken) return
    spoken = true
    const tag = asked ?? firstLanguage(this.getAttribute('src') ?? '', '')
    if (tag !== language.tag) await language.speak(tag).catch((error: unknown) => console.warn(error))
  }

  private see(visible: boolean): void {
    this.visible = visible
    if (!visible) {
      const { playback } = this.shown?.lab ?? {}
      if (playback?.playing) {
        this.resumes = true
        playback.pause()
      }
    } else if (!this.shown) {
      this.shown = this.begin()
    } else if (this.resumes) {
      this.resumes = false
      this.shown.lab.playback.play()
    }
  }

  private async openAgain(): Promise<void> {
    try {
      this.look.lesson = this.lesson
      if (this.look.lesson) return
      await this.shown?.lab.openLink(await this.link())
      this.playAlone()
    } catch (error) {
      this.fail(error)
    }
  }

  private get lesson(): Place | null {
    return lessonIn(this.getAttribute('src')?.trim() ?? '')
  }

  /** The link that the attributes ask for. */
  private async link(): Promise<string> {
    return linkOf((name) => this.getAttribute(name), await host().catalogue())
  }

  private playAlone(): void {
    if (!this.hasAttribute('autoplay') || stillness.matches) return
    if (this.visible) this.shown?.lab.playback.play()
    else this.resumes = true
  }

  private begin(): Shown {
    const address = { first: null as string | null, watched: false, write: () => undefined }
    const lab = new Lab(address, this.theme, STANDARD)
    const target = this.shadowRoot ?? this.attachShadow({ mode: 'open' })
    const room = mount(Run, { target, props: { lab, look: this.look } })
    const silence = tell(lab, (event) => this.dispatch(event))
    const reflecting = $effect.root(() => {
      $effect(() => {
        for (const [name, value] of Object.entries(attributesOf(lab))) this.setAttribute(name, value)
      })
      $effect(() => {
        this.dataset.theme = lab.theme.dark ? 'dark' : 'light'
      })
    })
    void this.start(lab, address)
    return {
      lab,
      end: () => {
        silence()
        reflecting()
        lab.close()
        void unmount(room)
      },
    }
  }

  private async start(lab: Lab, address: { first: string | null }): Promise<void> {
    try {
      this.look.lesson = this.lesson
      address.first = await (this.look.lesson ? null : this.link())
      if (!isChosen) await this.speak()
      // It may have been taken away meanwhile.
      if (this.shown?.lab !== lab) return
      await lab.open()
      this.playAlone()
    } catch (error) {
      this.fail(error)
    }
  }

  private fail(error: unknown): void {
    this.dispatch({ is: 'error', message: error instanceof Error ? error.message : String(error) })
  }

  private dispatch(event: RunEvent): void {
    this.dispatchEvent(new CustomEvent(event.is, { detail: event.is === 'error' ? { message: event.message } : event.state }))
  }
}
